#include "core/sampling/moment_flux.h"

#include <sherd/settings.h>

#include <algorithm>
#include <array>

#include "core/numerics/parallel_chunks.h"
#include "core/numerics/triangle_rule.h"
#include "core/numerics/wide_vectors.h"
#include "core/sampling/polygon_clipping.h"

namespace sherd {
namespace {

constexpr int most_points = 64;                             // that are summed up at a time
constexpr int most_powers = 2 * largest_spline_degree + 1;  // a direction
constexpr int group = wide_count;  // products with one power of y: x, x^2/2, ... x^N/N, 1, and zeros

using Group = WideDoubles;

/// Quadrature points on the surface.
struct FluxPoints {
    Group along_x[most_points];
    double along_y[most_powers][most_points];  // y^b
    double weights[most_powers][most_points];  // z^c times the x component of the area
    int count = 0;
};

/// sums[c][b] += sum over points of weights[c] y^b along_x, with N powers a direction. The sums of one power
/// of y stay in registers.
template <int N>
inline __attribute__((always_inline)) void sumUp(const FluxPoints& points, double* sums) {
    for (int b = 0; b < N; ++b) {
        Group own[N] = {};
        for (int k = 0; k < points.count; ++k) {
            const Group row = points.along_y[b][k] * points.along_x[k];
            for (int c = 0; c < N; ++c) own[c] += points.weights[c][k] * row;
        }
        for (int c = 0; c < N; ++c)
            for (int a = 0; a < group; ++a) sums[(c * N + b) * group + a] += own[c][a];
    }
}

SHERD_WIDE_VECTORS void sumUp1(const FluxPoints& points, double* sums) {
    sumUp<1>(points, sums);
}
SHERD_WIDE_VECTORS void sumUp3(const FluxPoints& points, double* sums) {
    sumUp<3>(points, sums);
}
SHERD_WIDE_VECTORS void sumUp5(const FluxPoints& points, double* sums) {
    sumUp<5>(points, sums);
}
SHERD_WIDE_VECTORS void sumUp7(const FluxPoints& points, double* sums) {
    sumUp<7>(points, sums);
}

/// Adds up the flux of polygons.
class FluxSum {
  public:
    explicit FluxSum(int order)
        : powers_(order + 1),
          sum_up_(order == 0   ? sumUp1
                  : order == 2 ? sumUp3
                  : order == 4 ? sumUp5
                               : sumUp7) {
        for (int i = 0; i < group; ++i) inverse_[i] = 1.0 / (i + 1);
        // Gradients of splines of degree p = order / 2 have the flux degree 3 p + 1; n points a side are
        // exact to 2 n - 2. The error of fewer points falls with the size of the triangle, as size^(2 n): far
        // below 1e-8 for these.
        const int exact = (3 * order / 2 + 4) / 2;
        for (const int points : {exact - 3, exact - 2, exact, exact + 2})
            rules_.push_back(triangleRule(2 * std::max(3, points) - 2));
    }

    /// Numbers that `add` adds to.
    std::size_t size() const { return static_cast<std::size_t>(powers_ * powers_ * group); }

    void add(const Polygon& polygon, const Vec3& centre, double scale, double* sums) const {
        FluxPoints points;
        const Vec3 a = (polygon.points[0] - centre) * scale;
        for (int i = 1; i + 1 < polygon.count; ++i) {
            const Vec3 b = (polygon.points[i] - centre) * scale - a,
                       c = (polygon.points[i + 1] - centre) * scale - a;
            const double area = b.y() * c.z() - b.z() * c.y();
            if (area == 0) continue;
            const double size = std::max(b.squaredNorm(), c.squaredNorm());
            const TriangleRule& rule = rules_[size < 0.001 ? 0 : size < 0.02 ? 1 : size < 0.2 ? 2 : 3];
            const int count = static_cast<int>(rule.weights.size());
            for (int k = 0; k < count; ++k) {
                if (points.count == most_points) flush(points, sums);
                const double u = rule.u[k], v = rule.v[k];
                const Vec3 x = a + u * b + v * c;
                addPoint(x, area * rule.weights[k], points);
            }
        }
        flush(points, sums);
    }

    MomentFlux unpacked(const std::vector<double>& sums) const {
        MomentFlux flux;
        flux.volume.reserve(static_cast<std::size_t>(powers_ * powers_ * powers_));
        for (std::size_t begin = 0; begin < sums.size(); begin += group) {
            flux.volume.insert(flux.volume.end(), sums.begin() + begin, sums.begin() + begin + powers_);
            flux.face.push_back(sums[begin + powers_]);
        }
        return flux;
    }

  private:
    void addPoint(const Vec3& x, double weight, FluxPoints& points) const {
        Group& along_x = points.along_x[points.count];
        along_x = Group{};
        double power = x.x(), y = 1;
        for (int a = 0; a < powers_; ++a, power *= x.x()) along_x[a] = power * inverse_[a];
        along_x[powers_] = 1;
        for (int b = 0; b < powers_; ++b, y *= x.y()) points.along_y[b][points.count] = y;
        for (int c = 0; c < powers_; ++c, weight *= x.z()) points.weights[c][points.count] = weight;
        ++points.count;
    }

    void flush(FluxPoints& points, double* sums) const {
        sum_up_(points, sums);
        points.count = 0;
    }

    int powers_;
    std::array<double, group> inverse_;
    void (*sum_up_)(const FluxPoints&, double*);
    std::vector<TriangleRule> rules_;  // by the size of the triangle, the smallest first
};

using Sums = std::vector<double>;

/// Of a range of the surface's triangles. Voxels that none of them meets keep empty lists.
std::vector<Sums> fluxOf(const TriangleMesh& surface, int first, int last, const SamplingGrid& grid,
                         const CutSurface& cut, const CellColumns& columns, const FluxSum& flux) {
    const int per_cell = grid.cells_per_spacing;
    std::vector<Sums> sums(cut.voxels.size());
    forEachVoxelPiece(surface, first, last, grid, [&](const Eigen::Vector3i& voxel, const Polygon& polygon) {
        if (voxel.x() / per_cell < columns.first) return;
        Sums& own = sums[cut.cut_voxel_at[grid.indexOf(voxel)]];
        if (own.empty()) own.assign(flux.size(), 0.0);
        const Vec3 centre = (voxel / per_cell).cast<double>() * per_cell + Vec3::Constant(0.5 * per_cell);
        flux.add(polygon, centre, 1.0 / per_cell, own.data());
    });
    return sums;
}

}  // namespace

std::vector<MomentFlux> momentFlux(const TriangleMesh& surface, const SamplingGrid& grid,
                                   const CutSurface& cut, const CellColumns& columns, int order) {
    constexpr int ranges = 4;  // fixed, so that sums do not depend on the number of threads
    const int triangles = static_cast<int>(surface.triangles.size());
    const FluxSum flux(order);
    std::array<std::vector<Sums>, ranges> parts;
    forEachChunk(ranges, [&](int range) {
        parts[range] = fluxOf(surface, chunkBegin(range, ranges, triangles),
                              chunkBegin(range + 1, ranges, triangles), grid, cut, columns, flux);
    });
    std::vector<MomentFlux> result(cut.voxels.size());
    Sums sums;
    for (std::size_t v = 0; v < result.size(); ++v) {
        sums.assign(flux.size(), 0.0);
        for (const std::vector<Sums>& part : parts)
            for (std::size_t i = 0; i < part[v].size(); ++i) sums[i] += part[v][i];
        result[v] = flux.unpacked(sums);
    }
    return result;
}

}  // namespace sherd
