#include "core/sampling/surface_pieces.h"

#include <cmath>

#include "core/numerics/wide_vectors.h"
#include "core/sampling/polygon_clipping.h"

namespace sherd {
namespace {

constexpr int lane_count = 8;  // triangles that are measured at a time

/// Of each triangle a number.
using Lane = double[lane_count];

/// Corners of triangles from the centre of their voxel.
struct TriangleLanes {
    Lane a[3] = {}, b[3] = {}, c[3] = {};
};

/// What triangles add to the flux, whose faces begin with their areas, their sizes, and centroids times size.
struct MeasuredLanes {
    Lane volume[10], face[3][6], size, centroid[3];
};

constexpr double third = 1.0 / 3, twelfth = 1.0 / 12, sixtieth = 1.0 / 60;

/// Integrals of monomials over one of the triangles, exact up to degree 3, per unit area.
struct TriangleMonomials {
    double a[3], b[3], c[3], sum[3];

    SHERD_INLINED TriangleMonomials(const TriangleLanes& of, int lane) {
        for (int i = 0; i < 3; ++i) {
            a[i] = of.a[i][lane];
            b[i] = of.b[i][lane];
            c[i] = of.c[i][lane];
            sum[i] = a[i] + b[i] + c[i];
        }
    }
    SHERD_INLINED double products(int i, int j) const { return a[i] * a[j] + b[i] * b[j] + c[i] * c[j]; }
    SHERD_INLINED double of(int i) const { return third * sum[i]; }
    SHERD_INLINED double of(int i, int j) const { return twelfth * (sum[i] * sum[j] + products(i, j)); }
    SHERD_INLINED double of(int i, int j, int k) const {
        return sixtieth *
               (sum[i] * sum[j] * sum[k] + sum[i] * products(j, k) + sum[j] * products(k, i) +
                sum[k] * products(i, j) + 2 * (a[i] * a[j] * a[k] + b[i] * b[j] * b[k] + c[i] * c[j] * c[k]));
    }
};

SHERD_WIDE_VECTORS
void measureLanes(const TriangleLanes& triangles, MeasuredLanes& measured) {
    for (int l = 0; l < lane_count; ++l) {
        const TriangleMonomials m(triangles, l);
        double u[3], v[3], area[3];
        for (int i = 0; i < 3; ++i) {
            u[i] = m.b[i] - m.a[i];
            v[i] = m.c[i] - m.a[i];
        }
        area[0] = (u[1] * v[2] - u[2] * v[1]) / 2;
        area[1] = (u[2] * v[0] - u[0] * v[2]) / 2;
        area[2] = (u[0] * v[1] - u[1] * v[0]) / 2;
        const double nx = area[0];
        measured.volume[0][l] = nx * m.of(0);
        measured.volume[1][l] = nx * (m.of(0, 0) / 2);
        measured.volume[2][l] = nx * m.of(0, 1);
        measured.volume[3][l] = nx * m.of(0, 2);
        measured.volume[4][l] = nx * (third * m.of(0, 0, 0));
        measured.volume[5][l] = nx * (m.of(0, 0, 1) / 2);
        measured.volume[6][l] = nx * (m.of(0, 0, 2) / 2);
        measured.volume[7][l] = nx * m.of(0, 1, 1);
        measured.volume[8][l] = nx * m.of(0, 1, 2);
        measured.volume[9][l] = nx * m.of(0, 2, 2);
        for (int d = 0; d < 3; ++d) {
            measured.face[d][0][l] = area[d];
            measured.face[d][1][l] = area[d] * m.of((d + 1) % 3);
            measured.face[d][2][l] = area[d] * m.of((d + 2) % 3);
        }
        measured.face[0][3][l] = nx * m.of(1, 1);
        measured.face[0][4][l] = nx * m.of(1, 2);
        measured.face[0][5][l] = nx * m.of(2, 2);
        const double size = std::sqrt(area[0] * area[0] + area[1] * area[1] + area[2] * area[2]);
        measured.size[l] = size;
        for (int d = 0; d < 3; ++d) measured.centroid[d][l] = third * size * m.sum[d];
    }
}

/// Measures polygons, several at a time. They are summed as fans of triangles, so that the fans of a closed
/// surface still close where rounding has made a polygon not quite planar.
class PieceMeasure {
  public:
    explicit PieceMeasure(CutSurface& cut) : cut_(cut) {}

    void add(const Polygon& polygon, const Vec3& centre, int cut_voxel) {
        const Vec3 a = polygon.points[0] - centre;
        cut_.pieces.emplace_back();
        cut_.pieces.back().cut_voxel = cut_voxel;
        corners_.push_back(a);
        for (int i = 1; i + 1 < polygon.count; ++i) {
            if (count_ == lane_count) flush();
            const Vec3 b = polygon.points[i] - centre, c = polygon.points[i + 1] - centre;
            for (int d = 0; d < 3; ++d) {
                triangles_.a[d][count_] = a[d];
                triangles_.b[d][count_] = b[d];
                triangles_.c[d][count_] = c[d];
            }
            piece_of_[count_++] = static_cast<int>(cut_.pieces.size()) - 1;
        }
    }

    /// After the last polygon.
    void finish() {
        flush();
        for (std::size_t p = 0; p < cut_.pieces.size(); ++p) {
            Vec3& centroid = cut_.pieces[p].centroid;
            centroid = sizes_[p] > 0 ? Vec3(centroid / sizes_[p]) : corners_[p];
        }
    }

  private:
    /// Adds what was collected, in its order.
    void flush() {
        MeasuredLanes measured;
        measureLanes(triangles_, measured);
        sizes_.resize(cut_.pieces.size(), 0.0);
        for (int l = 0; l < count_; ++l) {
            SurfacePiece& piece = cut_.pieces[piece_of_[l]];
            SurfaceFlux& flux = cut_.flux[piece.cut_voxel];
            for (int i = 0; i < 10; ++i) flux.volume[i] += measured.volume[i][l];
            for (int d = 0; d < 3; ++d)
                for (int i = 0; i < (d == 0 ? 6 : 3); ++i) flux.face[d][i] += measured.face[d][i][l];
            for (int d = 0; d < 3; ++d) {
                piece.area[d] += measured.face[d][0][l];
                piece.centroid[d] += measured.centroid[d][l];
            }
            sizes_[piece_of_[l]] += measured.size[l];
        }
        count_ = 0;
    }

    CutSurface& cut_;
    std::vector<Vec3> corners_;  // #pieces
    std::vector<double> sizes_;  // #pieces
    TriangleLanes triangles_;
    int piece_of_[lane_count] = {}, count_ = 0;
};

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
    PieceMeasure measure(cut);
    forEachVoxelPiece(surface, 0, int(surface.triangles.size()), grid,
                      [&](const Eigen::Vector3i& voxel, const Polygon& polygon) {
                          int& index = cut.cut_voxel_at[std::size_t(grid.indexOf(voxel))];
                          if (index < 0) {
                              index = int(cut.voxels.size());
                              cut.voxels.push_back(grid.indexOf(voxel));
                              cut.flux.emplace_back();
                          }
                          const Vec3 centre = voxel.cast<double>() + Vec3::Constant(0.5);
                          measure.add(polygon, centre, index);
                      });
    measure.finish();
    return cut;
}

}  // namespace sherd
