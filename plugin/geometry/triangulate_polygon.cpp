#include "geometry/triangulate_polygon.h"

#if defined(__GNUC__) && !defined(__clang__)
// g++ 12 takes iterators of CGAL that are never used here for unset values.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <exception>

namespace sherd {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangles = std::vector<std::array<int, 3>>;

Triangles fan(int count) {
    Triangles triangles;
    for (int i = 2; i < count; ++i) triangles.push_back({0, i - 1, i});
    return triangles;
}

/// Whether all triangles of the fan turn the same way.
bool isFanOfOneSide(const std::vector<Vec3>& corners) {
    const auto areaOf = [&](std::size_t i) -> Vec3 {
        return (corners[i - 1] - corners[0]).cross(corners[i] - corners[0]);
    };
    Vec3 whole = Vec3::Zero();
    for (std::size_t i = 2; i < corners.size(); ++i) whole += areaOf(i);
    for (std::size_t i = 2; i < corners.size(); ++i)
        if (areaOf(i).dot(whole) < 0) return false;
    return true;
}

bool areFinite(const std::vector<Vec3>& corners) {
    return std::all_of(corners.begin(), corners.end(), [](const Vec3& v) { return v.allFinite(); });
}

/// Without long or thin triangles where that can be; none if the polygon folds over itself.
Triangles constrainedDelaunay(const std::vector<Vec3>& corners) {
    Mesh mesh;
    std::vector<Mesh::Vertex_index> around;
    for (const Vec3& corner : corners)
        around.push_back(mesh.add_vertex({corner.x(), corner.y(), corner.z()}));
    const Mesh::Face_index face = mesh.add_face(around);
    if (face == Mesh::null_face() || !CGAL::Polygon_mesh_processing::triangulate_face(face, mesh)) return {};
    Triangles triangles;
    for (const Mesh::Face_index part : mesh.faces()) {
        std::vector<int> own;
        for (const Mesh::Vertex_index vertex : mesh.vertices_around_face(mesh.halfedge(part)))
            own.push_back(static_cast<int>(vertex.idx()));
        if (own.size() != 3) return {};
        triangles.push_back({own[0], own[1], own[2]});
    }
    return triangles;
}

}  // namespace

std::vector<std::array<int, 3>> triangulatePolygon(const std::vector<Vec3>& corners) {
    const int count = static_cast<int>(corners.size());
    if (count <= 3 || !areFinite(corners) || isFanOfOneSide(corners)) return fan(count);
    try {
        Triangles triangles = constrainedDelaunay(corners);
        if (static_cast<int>(triangles.size()) == count - 2) return triangles;
    } catch (const std::exception&) {  // edges that cross
    }
    return fan(count);
}

}  // namespace sherd
