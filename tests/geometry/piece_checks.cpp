#include "piece_checks.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
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

}  // namespace sherd::fragment_support
