#include "bullet/flat_sides.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sherd {

namespace {

constexpr double same_way = 0.9;  // cosine of the angle up to which neighbours may be in one plane

class Sides {
  public:
    Sides(const std::vector<Vec3>& points, const std::vector<HullTriangle>& triangles, double even_m)
        : points_(points), triangles_(triangles), even_m_(even_m), is_taken_(triangles.size(), 0) {}

    std::vector<FlatSide> find() {
        std::vector<FlatSide> sides;
        for (const int triangle : largestFirst()) {
            if (is_taken_[triangle]) continue;
            takeInPlaneOf(triangle);
            FlatSide side{lineAround(), triangles_[triangle].normal};
            if (side.corners.empty()) {
                const auto& corners = triangles_[triangle].corners;
                side.corners.assign(corners.begin(), corners.end());
                for (const int given_back : in_plane_) is_taken_[given_back] = given_back == triangle;
            }
            sides.push_back(std::move(side));
        }
        return sides;
    }

  private:
    Vec3 corner(int triangle, int i) const { return points_[triangles_[triangle].corners[i]]; }

    /// Those that have an area.
    std::vector<int> largestFirst() const {
        std::vector<double> areas;
        std::vector<int> order;
        for (std::size_t t = 0; t < triangles_.size(); ++t) {
            const int triangle = static_cast<int>(t);
            const Vec3 a = corner(triangle, 0);
            areas.push_back((corner(triangle, 1) - a).cross(corner(triangle, 2) - a).squaredNorm());
            if (!triangles_[t].normal.isZero(0)) order.push_back(triangle);
        }
        std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return areas[a] > areas[b]; });
        return order;
    }

    /// Either way round: where points lie in a plane but for rounding, triangles are folded over each other.
    bool isInPlane(int triangle, const Vec3& normal, double height) const {
        const Vec3& own = triangles_[triangle].normal;
        if (!own.isZero(0) && std::abs(own.dot(normal)) < same_way) return false;
        for (int i = 0; i < 3; ++i)
            if (normal.dot(corner(triangle, i)) < height - even_m_) return false;
        return true;
    }

    void takeInPlaneOf(int first) {
        const Vec3& normal = triangles_[first].normal;
        const double height = normal.dot(corner(first, 0));
        in_plane_.assign(1, first);
        is_taken_[first] = 1;
        for (std::size_t i = 0; i < in_plane_.size(); ++i)
            for (const int next : triangles_[in_plane_[i]].neighbours) {
                if (is_taken_[next] || !isInPlane(next, normal, height)) continue;
                is_taken_[next] = 1;
                in_plane_.push_back(next);
            }
    }

    /// Around the triangles in the plane; nothing if that is not one line that meets no point twice.
    std::vector<int> lineAround() const {
        std::vector<std::array<int, 2>> edges;
        for (const int triangle : in_plane_)
            for (int i = 0; i < 3; ++i) {
                const int beyond = triangles_[triangle].neighbours[i];
                if (std::find(in_plane_.begin(), in_plane_.end(), beyond) != in_plane_.end()) continue;
                const auto& corners = triangles_[triangle].corners;
                edges.push_back({corners[i], corners[(i + 1) % 3]});
            }
        std::vector<int> line;
        if (edges.empty()) return line;
        for (int at = edges.front()[0]; line.size() < edges.size();) {
            line.push_back(at);
            const auto from_here = [&](const auto& edge) { return edge[0] == at; };
            const auto next = std::find_if(edges.begin(), edges.end(), from_here);
            if (next == edges.end() || std::find_if(next + 1, edges.end(), from_here) != edges.end())
                return {};
            at = (*next)[1];
            if ((at == line.front()) != (line.size() == edges.size())) return {};
        }
        return line;
    }

    const std::vector<Vec3>& points_;
    const std::vector<HullTriangle>& triangles_;
    const double even_m_;
    std::vector<char> is_taken_;
    std::vector<int> in_plane_;
};

}  // namespace

std::vector<FlatSide> flatSides(const std::vector<Vec3>& points, const std::vector<HullTriangle>& triangles,
                                double even_m) {
    return Sides(points, triangles, even_m).find();
}

}  // namespace sherd
