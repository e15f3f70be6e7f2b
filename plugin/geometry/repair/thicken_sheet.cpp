#include "geometry/repair/thicken_sheet.h"

#if defined(__GNUC__) && !defined(__clang__)
// g++ 12 takes iterators of CGAL's that are never used here for unset values.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/extrude.h>

#include <utility>
#include <vector>

#include "core/numerics/mesh_measures.h"
#include "geometry/repair/cgal_mesh.h"

namespace sherd {
namespace {

/// Seen from its middle, a sheet faces outward that encloses more than it leaves out.
TriangleMesh facingOutward(TriangleMesh sheet) {
    if (enclosedVolume(sheet.vertices, sheet.triangles, boundingBox(sheet).center()) < 0)
        for (auto& t : sheet.triangles) std::swap(t[1], t[2]);
    return sheet;
}

}  // namespace

TriangleMesh thickened(const TriangleMesh& sheet, double thickness) {
    using Vertex = RepairMesh::Vertex_index;
    const RepairMesh outer = toRepairMesh(facingOutward(sheet));
    RepairMesh walls;
    CGAL::Polygon_mesh_processing::extrude_mesh(
        outer, walls,
        [&](Vertex from, Vertex to) {
            const auto normal = CGAL::Polygon_mesh_processing::compute_vertex_normal(from, outer);
            walls.point(to) = walls.point(to) - thickness * normal;
        },
        [](Vertex, Vertex) {});
    return toTriangleMesh(walls);
}

bool hasBorder(const TriangleMesh& mesh) {
    return !CGAL::is_closed(toRepairMesh(mesh));
}

}  // namespace sherd
