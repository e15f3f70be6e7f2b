#include "geometry/convex/corners_of_feet.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "core/loads/convex_hull_2d.h"
#include "core/numerics/mesh_measures.h"
#include "core/numerics/union_find.h"

namespace sherd {

namespace {

constexpr double parallel = 0.999;       // cosine between normals of one plane
constexpr std::size_t most_planes = 64;  // of the largest triangles; round bodies have no end of them

/// That a body can stand on: all of it is on one side.
struct Support {
    Vec3 normal;
    double height = 0;
    std::vector<int> triangles;

    double above(const Vec3& x) const { return normal.dot(x) - height; }
};

bool isIn(const Support& plane, const TriangleCorners& corners, const Vec3& normal, double tolerance_m) {
    return plane.normal.dot(normal) > parallel &&
           std::all_of(corners.begin(), corners.end(),
                       [&](const Vec3& corner) { return std::abs(plane.above(corner)) < tolerance_m; });
}

std::vector<Support> supportsOf(const TriangleMesh& surface, const std::vector<Vec3>& hull,
                                double tolerance_m) {
    std::vector<double> areas;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        areas.push_back(areaVector(cornersOf(surface, t)).norm());
    std::vector<int> largest_first(areas.size());
    std::iota(largest_first.begin(), largest_first.end(), 0);
    std::stable_sort(largest_first.begin(), largest_first.end(),
                     [&](int a, int b) { return areas[a] > areas[b]; });
    std::vector<Support> supports;
    for (const int t : largest_first) {
        if (!(areas[t] > 0)) break;
        const TriangleCorners corners = cornersOf(surface, static_cast<std::size_t>(t));
        const Vec3 normal = areaVector(corners) / areas[t];
        const auto known = std::find_if(supports.begin(), supports.end(), [&](const Support& plane) {
            return isIn(plane, corners, normal, tolerance_m);
        });
        if (known != supports.end()) {
            known->triangles.push_back(t);
            continue;
        }
        if (supports.size() == most_planes) continue;
        const Support plane{normal, normal.dot(corners[0]), {t}};
        if (std::none_of(hull.begin(), hull.end(),
                         [&](const Vec3& vertex) { return plane.above(vertex) > tolerance_m; }))
            supports.push_back(plane);
    }
    return supports;
}

/// The vertices of each face in a plane. Faces between which the surface hardly leaves the plane are one: a
/// round side that is rough has many.
std::vector<std::vector<int>> facesIn(const Support& plane, const TriangleMesh& surface, double tolerance_m) {
    constexpr double shallow = 10;  // tolerances
    UnionFind joined(surface.vertices.size());
    for (const auto& [a, b, c] : surface.triangles)
        if (std::min({plane.above(surface.vertices[a]), plane.above(surface.vertices[b]),
                      plane.above(surface.vertices[c])}) > -shallow * tolerance_m) {
            joined.unite(a, b);
            joined.unite(b, c);
        }
    std::vector<int> vertices;
    for (const int t : plane.triangles) {
        const auto& [a, b, c] = surface.triangles[t];
        vertices.insert(vertices.end(), {a, b, c});
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    std::map<int, std::vector<int>> by_root;
    for (const int vertex : vertices) by_root[joined.root(vertex)].push_back(vertex);
    std::vector<std::vector<int>> faces;
    for (auto& [root, face] : by_root) faces.push_back(std::move(face));
    return faces;
}

}  // namespace

std::vector<Vec3> cornersOfFeet(const TriangleMesh& surface, const std::vector<Vec3>& hull,
                                double tolerance_m) {
    std::vector<Vec3> found;
    for (const Support& plane : supportsOf(surface, hull, tolerance_m)) {
        if (plane.triangles.size() < 2) continue;
        const std::vector<std::vector<int>> feet = facesIn(plane, surface, tolerance_m);
        if (feet.size() < 2) continue;
        const Vec3 along = plane.normal.unitOrthogonal(), across = plane.normal.cross(along);
        for (const std::vector<int>& foot : feet) {
            std::vector<Vec2> places;
            for (const int vertex : foot) {
                const Vec3& x = surface.vertices[vertex];
                places.emplace_back(along.dot(x), across.dot(x));
            }
            for (const Vec2& corner : convexHull(places)) {
                const auto place = std::find(places.begin(), places.end(), corner) - places.begin();
                found.push_back(surface.vertices[foot[static_cast<std::size_t>(place)]]);
            }
        }
    }
    return found;
}

}  // namespace sherd
