#include "core/sampling/surface_pieces.h"

#include "core/sampling/polygon_clipping.h"

namespace sherd {
namespace {

/// Integrals of monomials over a triangle, exact up to degree 3, per unit area.
struct TriangleMonomials {
    Vec3 a, b, c, sum;
    TriangleMonomials(const Vec3& a, const Vec3& b, const Vec3& c) : a(a), b(b), c(c), sum(a + b + c) {}

    double products(int i, int j) const { return a[i] * a[j] + b[i] * b[j] + c[i] * c[j]; }
    double of(int i) const { return sum[i] / 3; }
    double of(int i, int j) const { return (sum[i] * sum[j] + products(i, j)) / 12; }
    double of(int i, int j, int k) const {
        return (sum[i] * sum[j] * sum[k] + sum[i] * products(j, k) + sum[j] * products(k, i) +
                sum[k] * products(i, j) +
                2 * (a[i] * a[j] * a[k] + b[i] * b[j] * b[k] + c[i] * c[j] * c[k])) /
               60;
    }
};

void addTriangle(const TriangleMonomials& m, const Vec3& area, SurfaceFlux& flux) {
    const double nx = area.x();
    const std::array<double, 10> volume = {
        m.of(0),           m.of(0, 0) / 2,    m.of(0, 1),    m.of(0, 2),    m.of(0, 0, 0) / 3,
        m.of(0, 0, 1) / 2, m.of(0, 0, 2) / 2, m.of(0, 1, 1), m.of(0, 1, 2), m.of(0, 2, 2)};
    for (int i = 0; i < 10; ++i) flux.volume[i] += nx * volume[i];
    for (int d = 0; d < 3; ++d) {
        flux.face[d][0] += area[d];
        flux.face[d][1] += area[d] * m.of((d + 1) % 3);
        flux.face[d][2] += area[d] * m.of((d + 2) % 3);
    }
    flux.face[0][3] += nx * m.of(1, 1);
    flux.face[0][4] += nx * m.of(1, 2);
    flux.face[0][5] += nx * m.of(2, 2);
}

/// Adds the flux of a polygon and gives its area and centroid. It is summed as a fan of triangles, so that
/// the fans of a closed surface still close where rounding has made a polygon not quite planar.
SurfacePiece measure(const Polygon& polygon, const Vec3& centre, SurfaceFlux& flux) {
    SurfacePiece piece;
    double size = 0;
    const Vec3 a = polygon.points[0] - centre;
    for (int i = 1; i + 1 < polygon.count; ++i) {
        const Vec3 b = polygon.points[i] - centre, c = polygon.points[i + 1] - centre;
        const Vec3 area = (b - a).cross(c - a) / 2;
        const TriangleMonomials monomials(a, b, c);
        addTriangle(monomials, area, flux);
        piece.area += area;
        piece.centroid += area.norm() * monomials.sum / 3;
        size += area.norm();
    }
    piece.centroid = size > 0 ? Vec3(piece.centroid / size) : a;
    return piece;
}

/// Whether a polygon lies wholly outside the rows that a window covers.
bool isBeside(const Polygon& polygon, const SamplingGrid& grid) {
    for (int axis = 1; axis < 3; ++axis) {
        bool below = true, above = true;
        for (int i = 0; i < polygon.count; ++i) {
            below = below && polygon.points[i][axis] < 0;
            above = above && polygon.points[i][axis] > grid.count[axis];
        }
        if (below || above) return true;
    }
    return false;
}

}  // namespace

SurfaceFlux& SurfaceFlux::operator+=(const SurfaceFlux& other) {
    for (int i = 0; i < 10; ++i) volume[i] += other.volume[i];
    for (int d = 0; d < 3; ++d)
        for (int i = 0; i < 6; ++i) face[d][i] += other.face[d][i];
    return *this;
}

void forEachVoxelPiece(const TriangleMesh& surface, int first, int last, const SamplingGrid& grid,
                       const std::function<void(const Eigen::Vector3i&, const Polygon&)>& visit) {
    Polygon triangle, rest;
    for (int t = first; t < last; ++t) {
        triangle.count = 0;
        for (const int v : surface.triangles[std::size_t(t)])
            triangle.add(grid.toGrid(surface.vertices[std::size_t(v)]));
        triangle.close();
        if (grid.window && isBeside(triangle, grid)) continue;
        for (int axis = 1; grid.window && axis < 3; ++axis) {
            Polygon below, above;
            cutPolygon(triangle, axis, 0, below, above);
            cutPolygon(above, axis, grid.count[axis], below, rest);
            triangle.assign(below);
        }
        if (!grid.window) {
            forEachCellPiece(triangle, visit);
            continue;
        }
        // A polygon that touches the window's upper border leaves a piece without area beyond it.
        forEachCellPiece(triangle, [&](const Eigen::Vector3i& voxel, const Polygon& polygon) {
            if ((voxel.array() < grid.count.array()).all()) visit(voxel, polygon);
        });
    }
}

CutSurface cutSurface(const TriangleMesh& surface, const SamplingGrid& grid) {
    CutSurface cut;
    cut.cut_voxel_at.assign(std::size_t(grid.voxelCount()), -1);
    cut.pieces.reserve(2 * surface.triangles.size());
    forEachVoxelPiece(surface, 0, int(surface.triangles.size()), grid,
                      [&](const Eigen::Vector3i& voxel, const Polygon& polygon) {
                          int& index = cut.cut_voxel_at[std::size_t(grid.indexOf(voxel))];
                          if (index < 0) {
                              index = int(cut.voxels.size());
                              cut.voxels.push_back(grid.indexOf(voxel));
                              cut.flux.emplace_back();
                          }
                          const Vec3 centre = voxel.cast<double>() + Vec3::Constant(0.5);
                          cut.pieces.push_back(measure(polygon, centre, cut.flux[std::size_t(index)]));
                          cut.pieces.back().cut_voxel = index;
                      });
    return cut;
}

}  // namespace sherd
