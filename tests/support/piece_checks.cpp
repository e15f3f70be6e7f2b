#include "support/piece_checks.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <map>
#include <set>

namespace sherd::fragment_support {

std::string faultOf(const TriangleMesh& mesh) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
    namespace pmp = CGAL::Polygon_mesh_processing;
    Mesh surface;
    for (const Vec3& v : mesh.vertices) surface.add_vertex({v.x(), v.y(), v.z()});
    std::set<std::array<int, 3>> seen;
    for (std::array<int, 3> t : mesh.triangles) {
        const auto face =
            surface.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
        if (face == Mesh::null_face()) return "not manifold";
        std::sort(t.begin(), t.end());
        if (!seen.insert(t).second) return "doubled triangle";
    }
    if (surface.is_empty()) return "empty";
    if (!CGAL::is_closed(surface)) return "open";
    for (const auto face : surface.faces())
        if (pmp::is_degenerate_triangle_face(face, surface)) return "triangle without area";
    if (pmp::does_self_intersect(surface)) return "self-intersecting";
    return pmp::does_bound_a_volume(surface) && pmp::is_outward_oriented(surface) ? ""
                                                                                  : "not oriented outward";
}

std::array<Corner, 3> cornersOf(const TriangleMesh& mesh, std::size_t t, bool reversed) {
    std::array<Corner, 3> corners;
    for (int i = 0; i < 3; ++i) {
        const Vec3& v = mesh.vertices[mesh.triangles[t][reversed ? 2 - i : i]];
        corners[i] = {v.x(), v.y(), v.z()};
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    return corners;
}

std::string faultOfCracks(const std::vector<TriangleMesh>& pieces) {
    std::map<std::array<Corner, 3>, std::size_t> owner;
    const auto isCrack = [&](std::size_t p, std::size_t t) {
        return !pieces[p].kinds.empty() && pieces[p].kinds[t] == SurfaceKind::crack;
    };
    for (std::size_t p = 0; p < pieces.size(); ++p)
        for (std::size_t t = 0; t < pieces[p].triangles.size(); ++t)
            if (isCrack(p, t) && !owner.emplace(cornersOf(pieces[p], t, false), p).second)
                return "a crack triangle belongs to two pieces";
    for (std::size_t p = 0; p < pieces.size(); ++p)
        for (std::size_t t = 0; t < pieces[p].triangles.size(); ++t) {
            if (!isCrack(p, t)) continue;
            const auto partner = owner.find(cornersOf(pieces[p], t, true));
            if (partner == owner.end()) return "a crack triangle has no partner";
            if (partner->second == p) return "a crack triangle has its partner in its own piece";
        }
    return "";
}

}  // namespace sherd::fragment_support
