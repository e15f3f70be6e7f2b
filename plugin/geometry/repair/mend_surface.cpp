#include "geometry/repair/mend_surface.h"

#if defined(__GNUC__) && !defined(__clang__)
// g++ 12 takes callbacks and iterators of CGAL that are never used here for unset values.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <algorithm>
#include <iterator>

#include "core/numerics/mesh_measures.h"
#include "geometry/repair/cgal_mesh.h"

namespace sherd {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Face = RepairMesh::Face_index;
using HalfEdge = RepairMesh::Halfedge_index;

constexpr std::size_t largest_hole = 4000;  // edges; the search is quadratic
constexpr std::size_t largest_cubic = 300;  // where it fails, and all triangles are tried
constexpr double rim_of_a_sheet = 0.85;     // of the size: a bowl without thickness has 0.94,
constexpr double lid_of_a_sheet = 0.3;      // and a hole of half its area; a slab without a triangle has 0.27

std::vector<Vec3> pointsAround(const RepairMesh& mesh, HalfEdge border) {
    std::vector<Vec3> points;
    for (const auto h : mesh.halfedges_around_face(border)) {
        const auto& p = mesh.point(mesh.target(h));
        points.emplace_back(p.x(), p.y(), p.z());
    }
    return points;
}

double areaWithin(const std::vector<Vec3>& rim) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < rim.size(); ++i)
        sum += (rim[i] - rim[0]).cross(rim[(i + 1) % rim.size()] - rim[0]) / 2;
    return sum.norm();
}

}  // namespace

void removeFlat(TriangleMesh& mesh, RepairReport& report) {
    RepairMesh surface = toRepairMesh(mesh);
    int flat = 0;
    for (const Face face : surface.faces()) flat += pmp::is_degenerate_triangle_face(face, surface);
    if (flat == 0) return;
    pmp::remove_degenerate_faces(surface);
    report.flat_triangles += flat;
    mesh = toTriangleMesh(surface);
}

TriangleMesh fillHoles(TriangleMesh& mesh, double largest_m, RepairReport& report) {
    RepairMesh surface = toRepairMesh(mesh);
    std::vector<HalfEdge> borders;
    pmp::extract_boundary_cycles(surface, std::back_inserter(borders));
    if (borders.empty()) return {};
    const double size = boundingBox(mesh).diagonal().norm(), area = surfaceArea(mesh);
    std::vector<int> patch_faces;
    for (const HalfEdge border : borders) {
        const std::vector<Vec3> rim = pointsAround(surface, border);
        const double across = boundingBox(rim).diagonal().norm();
        const bool is_sheet = across > rim_of_a_sheet * size && areaWithin(rim) > lid_of_a_sheet * area;
        if (rim.size() > largest_hole || across > largest_m || is_sheet) continue;
        std::vector<Face> patch;
        pmp::triangulate_hole(surface, border, std::back_inserter(patch),
                              CGAL::parameters::do_not_use_cubic_algorithm(rim.size() > largest_cubic));
        if (patch.empty()) continue;
        for (const Face face : patch) patch_faces.push_back(static_cast<int>(std::size_t(face)));
        ++report.filled_holes;
        report.largest_hole_m = std::max(report.largest_hole_m, across);
    }
    mesh = toTriangleMesh(surface);
    return partOf(mesh, patch_faces);
}

}  // namespace sherd
