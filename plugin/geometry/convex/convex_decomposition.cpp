#include "geometry/convex/convex_decomposition.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "core/numerics/mesh_measures.h"
#include "core/numerics/parallel_chunks.h"
#include "geometry/convex/cut_tree.h"
#include "geometry/convex/possible_cuts.h"
#include "geometry/convex/surface_cloud.h"

namespace sherd {

namespace {

constexpr double in_plane = 1e-6;  // of the spacing of points: how near to a plane is in it

/// A part, and the volume of its hull that is not solid, m^3.
struct Part {
    SurfaceCloud cloud;
    Eigen::AlignedBox3d box;
    double hull_volume = 0, solid_volume = 0;

    Part(SurfaceCloud cut_off, double its_solid_volume)
        : cloud(std::move(cut_off)),
          box(boundingBox(cloud.points)),
          hull_volume(GrowingHull(cloud.points).volume()),
          solid_volume(its_solid_volume) {}
    double air() const { return hull_volume - solid_volume; }
    double price() const { return priceOf(hull_volume, box.diagonal().norm()); }
};

/// Of the halves, m^3, that are `whole` together; where it is not known of either, both have the same.
std::array<double, 2> solidVolumes(const std::array<SurfaceCloud, 2>& halves, double whole) {
    std::array<double, 2> volumes = {solidVolume(halves[0]), solidVolume(halves[1])};
    if (volumes[0] < 0) volumes[0] = volumes[1] < 0 ? whole / 2 : std::max(whole - volumes[1], 0.0);
    if (volumes[1] < 0) volumes[1] = std::max(whole - volumes[0], 0.0);
    return volumes;
}

/// The cheapest one.
struct Cut {
    AxisPlane plane;
    std::vector<Part> halves;  // below and above; none: there is nothing to cut
};

Cut bestCut(const Part& whole) {
    Cut best;
    double least = std::numeric_limits<double>::infinity();
    for (const AxisPlane& plane : possibleCuts(whole.cloud)) {
        std::array<SurfaceCloud, 2> clouds = parted(whole.cloud, plane);
        const std::array<double, 2> solid = solidVolumes(clouds, whole.solid_volume);
        // Where the half of more points is too dear already, the other one is not looked at.
        const int more = clouds[1].points.size() > clouds[0].points.size() ? 1 : 0;
        Part first(std::move(clouds[more]), solid[more]);
        if (first.price() > least) continue;
        Part second(std::move(clouds[1 - more]), solid[1 - more]);
        const double price = first.price() + second.price();
        if (price > least || (price == least && plane.axis > best.plane.axis)) continue;
        least = price;
        best = {plane, {}};
        best.halves.push_back(std::move(more ? second : first));
        best.halves.push_back(std::move(more ? first : second));
    }
    return best;
}

/// The corners of a part's box inside the solid, where no triangle of the surface is.
std::vector<Vec3> cornersInside(const SurfaceCloud& part, const SurfaceCloud& whole) {
    std::vector<Vec3> inside;
    for (int c = 0; c < 8; ++c) {
        Vec3 corner;
        for (int axis = 0; axis < 3; ++axis)
            corner[axis] = c >> axis & 1 ? part.cut_above[axis] : part.cut_below[axis];
        if (corner.allFinite() && isWellInside(corner, whole)) inside.push_back(corner);
    }
    return inside;
}

/// A part, and the cut through it once that is looked for.
struct Leaf {
    Part part;
    std::optional<Cut> cut;
};

/// Looks for the cuts through the airiest leaf and the one behind it, both at once: the next cut is mostly
/// through that one. `left`: how many cuts may follow.
void findCuts(std::vector<Leaf>& leaves, int left) {
    std::vector<Leaf*> airiest;
    for (Leaf& leaf : leaves)
        if (!leaf.cut) airiest.push_back(&leaf);
    const std::size_t count = std::min<std::size_t>({2, airiest.size(), static_cast<std::size_t>(left)});
    std::partial_sort(airiest.begin(), airiest.begin() + static_cast<long>(count), airiest.end(),
                      [](const Leaf* a, const Leaf* b) {
                          const double air = a->part.air(), other = b->part.air();
                          return air != other ? air > other : a < b;
                      });
    forEachChunk(static_cast<int>(count), [&](int i) { airiest[i]->cut = bestCut(airiest[i]->part); });
}

/// For each part of a solid the points whose hull is that of the part.
std::vector<std::vector<Vec3>> pointsOfParts(const TriangleMesh& surface, double volume,
                                             const DecompositionLimits& limits) {
    const SurfaceCloud whole = cloudOf(surface);
    std::vector<Leaf> leaves;  // in the order of the tree
    leaves.push_back({Part(whole, volume), {}});
    CutTree tree(in_plane * whole.spacing);
    while (tree.leafCount() < limits.most_parts) {
        const auto airiest = std::max_element(leaves.begin(), leaves.end(), [](const Leaf& a, const Leaf& b) {
            return a.part.air() < b.part.air();
        });
        if (airiest->part.air() <= limits.air_share * volume && tree.leafCount() > 1) break;
        if (!airiest->cut) findCuts(leaves, limits.most_parts - tree.leafCount());
        Cut cut = std::move(*airiest->cut);
        if (cut.halves.empty()) break;
        tree.cut(static_cast<int>(airiest - leaves.begin()), cut.plane);
        *airiest = {std::move(cut.halves[0]), {}};
        leaves.push_back({std::move(cut.halves[1]), {}});
    }
    std::vector<std::vector<Vec3>> points = tree.pointsOfLeaves(surface);
    for (std::size_t p = 0; p < leaves.size(); ++p) {
        const std::vector<Vec3> corners = cornersInside(leaves[p].part.cloud, whole);
        points[p].insert(points[p].end(), corners.begin(), corners.end());
    }
    return points;
}

}  // namespace

std::vector<ConvexHull> convexDecomposition(const TriangleMesh& surface, double volume,
                                            const DecompositionLimits& limits) {
    const double enough = (1 + limits.air_share_of_one_hull) * volume;
    std::vector<ConvexHull> hulls;
    GrowingHull rough(surface.vertices);
    if (limits.most_parts == 1 || rough.volume() <= enough) {
        hulls.push_back(
            simpleHull(surface.vertices, std::move(rough), limits.most_vertices, limits.tolerance_m));
        if (limits.most_parts == 1 || hulls.front().volume <= enough) return hulls;
        hulls.clear();
    }
    const std::vector<std::vector<Vec3>> points = pointsOfParts(surface, volume, limits);
    hulls.resize(points.size());
    forEachChunk(static_cast<int>(points.size()),
                 [&](int p) { hulls[p] = simpleHull(points[p], limits.most_vertices, limits.tolerance_m); });
    return hulls;
}

}  // namespace sherd
