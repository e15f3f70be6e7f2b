#include "core/sampling/moment_flux.h"

#include <algorithm>
#include <array>

#include "core/numerics/gauss_legendre.h"
#include "core/numerics/parallel_chunks.h"
#include "core/sampling/polygon_clipping.h"

namespace sherd {
namespace {

/// Adds up the flux of polygons; `order` + 1 powers a direction.
class FluxSum {
  public:
    explicit FluxSum(int order) : powers_(order + 1) {
        // Gradients of splines of degree p = order / 2 have the flux degree 3 p + 1; n points are exact to 2
        // n - 2. The error of fewer points falls with the size of the triangle, as size^(2 n): far below 1e-8
        // for these.
        const int exact = (3 * order / 2 + 4) / 2;
        for (const int points : {exact - 3, exact - 2, exact, exact + 2})
            rules_.push_back(gaussLegendre(std::max(3, points)));
    }

    void add(const Polygon& polygon, const Vec3& centre, double scale, bool with_volume,
             MomentFlux& flux) const {
        const Vec3 a = (polygon.points[0] - centre) * scale;
        for (int i = 1; i + 1 < polygon.count; ++i) {
            const Vec3 b = (polygon.points[i] - centre) * scale, c = (polygon.points[i + 1] - centre) * scale;
            if (powers_ == 1) addTriangle<1>(a, b, c, with_volume, flux);
            if (powers_ == 3) addTriangle<3>(a, b, c, with_volume, flux);
            if (powers_ == 5) addTriangle<5>(a, b, c, with_volume, flux);
            if (powers_ == 7) addTriangle<7>(a, b, c, with_volume, flux);
        }
    }

  private:
    /// Collapsed Gauss rule: x = a + u (b - a) + u v (c - b), dA = 2 A u du dv. N powers a direction, known
    /// to the compiler, which unrolls the sums.
    template <int N>
    void addTriangle(const Vec3& a, const Vec3& b, const Vec3& c, bool with_volume, MomentFlux& flux) const {
        const double area = (b - a).cross(c - a).x();
        if (area == 0) return;
        const double size = std::max((b - a).squaredNorm(), (c - a).squaredNorm());
        const GaussRule& rule = rules_[size < 0.001 ? 0 : size < 0.02 ? 1 : size < 0.2 ? 2 : 3];
        std::array<double, N> px, py, pz;
        for (size_t i = 0; i < rule.points.size(); ++i) {
            const double u = rule.points[i] + 0.5;
            const Vec3 start = a + u * (b - a), span = u * (c - b);
            for (size_t j = 0; j < rule.points.size(); ++j) {
                const Vec3 x = start + (rule.points[j] + 0.5) * span;
                const double weight = area * u * rule.weights[i] * rule.weights[j];
                double power = x.x();
                py[0] = pz[0] = 1;
                for (int k = 0; k < N; ++k, power *= x.x()) {
                    px[k] = power / (k + 1);
                    if (k == 0) continue;
                    py[k] = py[k - 1] * x.y();
                    pz[k] = pz[k - 1] * x.z();
                }
                double* volume = flux.volume.data();
                double* face = flux.face.data();
                for (int kc = 0; kc < N; ++kc)
                    for (int kb = 0; kb < N; ++kb) {
                        const double yz = weight * pz[kc] * py[kb];
                        *face++ += yz;
                        if (!with_volume) continue;
                        for (int ka = 0; ka < N; ++ka) *volume++ += yz * px[ka];
                    }
            }
        }
    }

    int powers_;
    std::vector<GaussRule> rules_;  // by the size of the triangle, the smallest first
};

MomentFlux noFlux(int powers) {
    return {std::vector<double>(powers * powers * powers, 0.0), std::vector<double>(powers * powers, 0.0)};
}

/// Of a range of the surface's triangles. Voxels that none of them meets keep empty lists.
std::vector<MomentFlux> fluxOf(const TriangleMesh& surface, int first, int last, const SamplingGrid& grid,
                               const CutSurface& cut, const CellColumns& columns, const FluxSum& sum,
                               int powers) {
    const int per_cell = grid.cells_per_spacing;
    std::vector<MomentFlux> flux(cut.voxels.size());
    forEachVoxelPiece(surface, first, last, grid, [&](const Eigen::Vector3i& voxel, const Polygon& polygon) {
        const int column = voxel.x() / per_cell;
        if (column < columns.first) return;
        MomentFlux& own = flux[cut.cut_voxel_at[grid.indexOf(voxel)]];
        if (own.face.empty()) own = noFlux(powers);
        const Vec3 centre = (voxel / per_cell).cast<double>() * per_cell + Vec3::Constant(0.5 * per_cell);
        sum.add(polygon, centre, 1.0 / per_cell, column < columns.last, own);
    });
    return flux;
}

}  // namespace

std::vector<MomentFlux> momentFlux(const TriangleMesh& surface, const SamplingGrid& grid,
                                   const CutSurface& cut, const CellColumns& columns, int order) {
    constexpr int ranges = 4;  // fixed, so that sums do not depend on the number of threads
    const int powers = order + 1, triangles = static_cast<int>(surface.triangles.size());
    const FluxSum sum(order);
    std::array<std::vector<MomentFlux>, ranges> parts;
    forEachChunk(ranges, [&](int range) {
        parts[range] = fluxOf(surface, chunkBegin(range, ranges, triangles),
                              chunkBegin(range + 1, ranges, triangles), grid, cut, columns, sum, powers);
    });
    std::vector<MomentFlux> flux(cut.voxels.size(), noFlux(powers));
    for (const std::vector<MomentFlux>& part : parts)
        for (size_t v = 0; v < flux.size(); ++v) {
            for (size_t i = 0; i < part[v].volume.size(); ++i) flux[v].volume[i] += part[v].volume[i];
            for (size_t i = 0; i < part[v].face.size(); ++i) flux[v].face[i] += part[v].face[i];
        }
    return flux;
}

}  // namespace sherd
