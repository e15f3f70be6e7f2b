#include "geometry/repair/thicken_sheet.h"

#if defined(__GNUC__) && !defined(__clang__)
// g++ 12 takes iterators of CGAL's that are never used here for unset values.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <CGAL/Polygon_mesh_processing/extrude.h>

#include <Eigen/Eigenvalues>
#include <utility>
#include <vector>

#include "core/numerics/mesh_measures.h"
#include "core/numerics/union_find.h"
#include "geometry/repair/cgal_mesh.h"

namespace sherd {
namespace {

/// Seen from the middle of its box, a sheet faces outward that encloses more than it leaves out: each
/// connected part by itself.
TriangleMesh facingOutward(TriangleMesh sheet) {
    UnionFind parts(static_cast<int>(sheet.vertices.size()));
    for (const auto& [a, b, c] : sheet.triangles) {
        parts.unite(a, b);
        parts.unite(a, c);
    }
    std::vector<Eigen::AlignedBox3d> boxes(sheet.vertices.size());
    for (std::size_t v = 0; v < sheet.vertices.size(); ++v)
        boxes[parts.root(static_cast<int>(v))].extend(sheet.vertices[v]);
    std::vector<double> volumes(sheet.vertices.size());
    for (const auto& t : sheet.triangles) {
        const int part = parts.root(t[0]);
        const Vec3 middle = boxes[part].center();
        volumes[part] += (sheet.vertices[t[0]] - middle)
                             .dot((sheet.vertices[t[1]] - middle).cross(sheet.vertices[t[2]] - middle));
    }
    for (auto& t : sheet.triangles)
        if (volumes[parts.root(t[0])] < 0) std::swap(t[1], t[2]);
    return sheet;
}

/// Per vertex the shortest way by which all faces around it lie one length deeper: along the normal, and
/// further where faces meet at an edge or a corner, up to three times.
std::vector<Vec3> waysOutward(const TriangleMesh& sheet) {
    std::vector<Mat3> facing(sheet.vertices.size(), Mat3::Zero());
    std::vector<Vec3> sums(sheet.vertices.size(), Vec3::Zero());
    for (std::size_t t = 0; t < sheet.triangles.size(); ++t) {
        const Vec3 area = areaVector(cornersOf(sheet, t));
        if (!(area.norm() > 0)) continue;
        for (const int v : sheet.triangles[t]) {
            facing[v] += area * area.transpose() / area.norm();
            sums[v] += area;
        }
    }
    constexpr double even = 0.02, furthest = 3;  // faces that are turned less are one
    std::vector<Vec3> ways(sums.size());
    for (std::size_t v = 0; v < sums.size(); ++v) {
        const Eigen::SelfAdjointEigenSolver<Mat3> solver(facing[v]);
        const double least = even * solver.eigenvalues().maxCoeff();
        Vec3 way = Vec3::Zero();
        for (int k = 0; k < 3; ++k)
            if (solver.eigenvalues()[k] > least)
                way += solver.eigenvectors().col(k) * solver.eigenvectors().col(k).dot(sums[v]) /
                       solver.eigenvalues()[k];
        ways[v] = way.norm() > furthest ? Vec3(furthest * way.normalized()) : way;
    }
    return ways;
}

}  // namespace

TriangleMesh thickened(const TriangleMesh& sheet, double thickness) {
    using Vertex = RepairMesh::Vertex_index;
    const TriangleMesh outer = facingOutward(sheet);
    const std::vector<Vec3> ways = waysOutward(outer);
    RepairMesh walls;
    CGAL::Polygon_mesh_processing::extrude_mesh(
        toRepairMesh(outer), walls,
        [&](Vertex from, Vertex to) {
            const Vec3 deeper = outer.vertices[from] - thickness * ways[from];
            walls.point(to) = {deeper.x(), deeper.y(), deeper.z()};
        },
        [](Vertex, Vertex) {});
    return toTriangleMesh(walls);
}

bool hasBorder(const TriangleMesh& mesh) {
    return !CGAL::is_closed(toRepairMesh(mesh));
}

}  // namespace sherd
