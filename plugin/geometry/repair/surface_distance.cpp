#include "geometry/repair/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "geometry/by_position.h"
#include "geometry/triangle_tree.h"

namespace sherd {
namespace {

/// Branch and bound over halved triangles. The distance to one triangle of `to` is a convex function, so over
/// a part of `from` it is largest at a corner, and the distance to all of `to` is no larger than that.
class DistanceSearch {
  public:
    DistanceSearch(const TriangleMesh& to, double tolerance) : tree_(to), tolerance_(tolerance) {}

    double over(const TriangleMesh& from) {
        std::vector<char> looked(from.vertices.size(), 0);
        for (const auto& triangle : from.triangles)
            for (const int corner : triangle)
                if (!std::exchange(looked[corner], 1)) look(from.vertices[corner]);
        for (std::size_t t = 0; t < from.triangles.size(); ++t) search(cornersOf(from, t));
        return largest_;
    }

  private:
    /// The triangle of `to` that is nearest to x.
    int look(const Vec3& x) {
        const TriangleTree::Foot foot = tree_.nearest(x);
        largest_ = std::max(largest_, (foot.position - x).norm());
        return foot.triangle;
    }

    void search(const TriangleCorners& part) {
        const Vec3 middle = (part[0] + part[1] + part[2]) / 3;
        const int nearest = look(middle);
        double bound = 0;
        int longest = 0;
        for (int k = 0; k < 3; ++k) {
            bound = std::max(bound, tree_.distance(part[k], nearest));
            const auto side = [&](int i) { return (part[(i + 1) % 3] - part[i]).squaredNorm(); };
            if (side(k) > side(longest)) longest = k;
        }
        const Vec3 &a = part[longest], &b = part[(longest + 1) % 3], &c = part[(longest + 2) % 3];
        if (bound <= largest_ + tolerance_ || (b - a).norm() <= tolerance_) return;
        search({a, (a + b) / 2, c});
        search({(a + b) / 2, b, c});
    }

    TriangleTree tree_;
    double tolerance_;
    double largest_ = 0;
};

/// The triangles of `mesh` that are not in `other` too: mending leaves most of a mesh as it is.
TriangleMesh without(const TriangleMesh& mesh, const TriangleMesh& other) {
    std::set<TriangleCorners, ByPositions> known;
    for (std::size_t t = 0; t < other.triangles.size(); ++t) known.insert(sortedCorners(other, t));
    TriangleMesh rest;
    rest.vertices = mesh.vertices;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (!known.count(sortedCorners(mesh, t))) rest.triangles.push_back(mesh.triangles[t]);
    return rest;
}

}  // namespace

double largestDistance(const TriangleMesh& from, const TriangleMesh& to, double tolerance) {
    const TriangleMesh changed = without(from, to);
    if (changed.triangles.empty() || to.triangles.empty()) return 0;
    return DistanceSearch(to, tolerance).over(changed);
}

}  // namespace sherd
