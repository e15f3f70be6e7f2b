#include "core/sampling/cell_moments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/numerics/gauss_legendre.h"
#include "core/numerics/parallel_chunks.h"
#include "core/sampling/polygon_clipping.h"

namespace sherd {
namespace {

constexpr double smallest_part = 1e-10;  // of a cell: less is rounding
constexpr double smallest_face = 1e-9;   // of a voxel face: parts that meet in less do not touch
constexpr double no_difference = 1e-13;  // of a cell's fill from 1: rounding
constexpr int chunk_count = 16;

/// Surface integrals over what the surface has in one voxel, n_x dA the x component of the outward area.
/// Coordinates from the middle of the voxel's cell, in edges of the cell.
struct MomentFlux {
    std::vector<double> volume;  // of n_x x^(a+1) / (a+1) y^b z^c
    std::vector<double> face;    // of n_x y^b z^c
};

/// Adds up the flux of polygons; `order` + 1 powers a direction.
class FluxSum {
  public:
    explicit FluxSum(int order) : n_(order + 1) {
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
            if (n_ == 1) addTriangle<1>(a, b, c, with_volume, flux);
            if (n_ == 3) addTriangle<3>(a, b, c, with_volume, flux);
            if (n_ == 5) addTriangle<5>(a, b, c, with_volume, flux);
            if (n_ == 7) addTriangle<7>(a, b, c, with_volume, flux);
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

    int n_;
    std::vector<GaussRule> rules_;
};

/// Columns of cells along x whose moments are asked for. Rows are swept from the top down: what lies below
/// does not count, and of what lies above only the flux through the faces.
struct Columns {
    int first, last;
};

/// Of a range of the surface's triangles. Voxels that none of them meets keep empty lists.
std::vector<MomentFlux> fluxOf(const TriangleMesh& surface, int first, int last, const SamplingGrid& grid,
                               const CutSurface& cut, const Columns& columns, const FluxSum& sum,
                               int powers) {
    const int per_cell = grid.cells_per_spacing;
    std::vector<MomentFlux> flux(cut.voxels.size());
    forEachVoxelPiece(surface, first, last, grid, [&](const Eigen::Vector3i& voxel, const Polygon& polygon) {
        const int column = voxel.x() / per_cell;
        if (column < columns.first) return;
        MomentFlux& own = flux[cut.cut_voxel_at[grid.indexOf(voxel)]];
        if (own.face.empty()) {
            own.volume.assign(powers * powers * powers, 0.0);
            own.face.assign(powers * powers, 0.0);
        }
        const Vec3 centre = (voxel / per_cell).cast<double>() * per_cell + Vec3::Constant(0.5 * per_cell);
        sum.add(polygon, centre, 1.0 / per_cell, column < columns.last, own);
    });
    return flux;
}

std::vector<MomentFlux> surfaceFlux(const TriangleMesh& surface, const SamplingGrid& grid,
                                    const CutSurface& cut, const Columns& columns, int order) {
    constexpr int ranges = 4;  // fixed, so that sums do not depend on the number of threads
    const int powers = order + 1, triangles = static_cast<int>(surface.triangles.size());
    const FluxSum sum(order);
    std::array<std::vector<MomentFlux>, ranges> parts;
    forEachChunk(ranges, [&](int range) {
        parts[range] = fluxOf(surface, chunkBegin(range, ranges, triangles),
                              chunkBegin(range + 1, ranges, triangles), grid, cut, columns, sum, powers);
    });
    std::vector<MomentFlux> flux(cut.voxels.size(), {std::vector<double>(powers * powers * powers, 0.0),
                                                     std::vector<double>(powers * powers, 0.0)});
    for (const std::vector<MomentFlux>& part : parts)
        for (size_t v = 0; v < flux.size(); ++v) {
            for (size_t i = 0; i < part[v].volume.size(); ++i) flux[v].volume[i] += part[v].volume[i];
            for (size_t i = 0; i < part[v].face.size(); ++i) flux[v].face[i] += part[v].face[i];
        }
    return flux;
}

/// Integral of t^k over an interval, k = 0 ... n - 1.
std::vector<double> intervalMoments(double lower, double upper, int n) {
    std::vector<double> result(n);
    double low = lower, high = upper;
    for (int k = 0; k < n; ++k, low *= lower, high *= upper) result[k] = (high - low) / (k + 1);
    return result;
}

/// Moments of every voxel in coordinates of its cell.
class VoxelMoments {
  public:
    VoxelMoments(const SamplingGrid& grid, const CutSurface& cut, const SolidVoxels& solid,
                 std::vector<MomentFlux> flux, int order)
        : grid_(grid), n_(order + 1), cut_of_(solid.index.size(), -1), flux_(std::move(flux)) {
        for (size_t c = 0; c < cut.voxels.size(); ++c)
            if (solid.of_cut_voxel[c] >= 0) cut_of_[solid.of_cut_voxel[c]] = static_cast<int>(c);
        for (int k = 0; k < grid.cells_per_spacing; ++k)
            intervals_.push_back(intervalMoments(coordinate(k), coordinate(k + 1), n_));
        sweepRows(cut, solid);
    }

    bool isWhole(int voxel) const { return cut_of_[voxel] < 0; }

    void addTo(int voxel, const Eigen::Vector3i& position, std::vector<double>& sum) const {
        const Eigen::Vector3i local =
            position - (position / grid_.cells_per_spacing) * grid_.cells_per_spacing;
        const std::vector<double>&x = intervals_[local.x()], &y = intervals_[local.y()],
              &z = intervals_[local.z()];
        if (isWhole(voxel)) {
            size_t i = 0;
            for (int c = 0; c < n_; ++c)
                for (int b = 0; b < n_; ++b)
                    for (int a = 0; a < n_; ++a) sum[i++] += x[a] * y[b] * z[c];
            return;
        }
        const std::vector<double>& volume = flux_[cut_of_[voxel]].volume;
        for (size_t i = 0; i < volume.size(); ++i) sum[i] += volume[i];
    }

  private:
    double coordinate(int k) const { return static_cast<double>(k) / grid_.cells_per_spacing - 0.5; }

    /// Walks the rows along x from the top down and turns the flux of every cut voxel into its moments.
    void sweepRows(const CutSurface& cut, const SolidVoxels& solid) {
        std::vector<char> whole(grid_.voxelCount(), 0);
        for (size_t v = 0; v < solid.index.size(); ++v)
            if (cut_of_[v] < 0) whole[solid.index[v]] = 1;
        std::vector<double> upper(n_ * n_);
        for (int k = 0; k < grid_.count.z(); ++k)
            for (int j = 0; j < grid_.count.y(); ++j) {
                std::fill(upper.begin(), upper.end(), 0.0);
                for (int i = grid_.count.x() - 1; i >= 0; --i) {
                    const Eigen::Vector3i position(i, j, k);
                    const long long index = grid_.indexOf(position);
                    const int voxel = cut.cut_voxel_at[index];
                    if (voxel >= 0)
                        close(flux_[voxel], i % grid_.cells_per_spacing, upper);
                    else
                        fill(position, whole[index], upper);
                }
            }
    }

    void close(MomentFlux& flux, int local, std::vector<double>& upper) const {
        double* volume = flux.volume.data();
        const double low = coordinate(local), high = coordinate(local + 1);
        for (int f = 0; f < n_ * n_; ++f) {
            const double lower = upper[f] + flux.face[f];
            double power_low = low, power_high = high;
            for (int a = 0; a < n_; ++a, power_low *= low, power_high *= high)
                *volume++ += (upper[f] * power_high - lower * power_low) / (a + 1);
            upper[f] = lower;
        }
    }

    /// No triangle comes near: the exact values, so that rounding does not travel along the row.
    void fill(const Eigen::Vector3i& position, bool whole, std::vector<double>& upper) const {
        const std::vector<double>&y = intervals_[position.y() % grid_.cells_per_spacing],
              &z = intervals_[position.z() % grid_.cells_per_spacing];
        for (int c = 0; c < n_; ++c)
            for (int b = 0; b < n_; ++b) upper[c * n_ + b] = whole ? y[b] * z[c] : 0;
    }

    const SamplingGrid& grid_;
    int n_;
    std::vector<int> cut_of_;  // per solid voxel: index of the cut voxel, or -1
    std::vector<MomentFlux> flux_;
    std::vector<std::vector<double>> intervals_;
};

int rootOf(std::vector<int>& parent, int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

/// Per voxel the lowest voxel of those in the same cell that it is connected to.
std::vector<int> connectedInCell(const SolidVoxels& solid, const std::vector<long long>& cell_of) {
    std::vector<int> parent(solid.index.size());
    std::iota(parent.begin(), parent.end(), 0);
    for (const VoxelFace& face : solid.faces) {
        if (face.area < smallest_face || cell_of[face.voxels[0]] != cell_of[face.voxels[1]]) continue;
        const int a = rootOf(parent, face.voxels[0]), b = rootOf(parent, face.voxels[1]);
        parent[std::max(a, b)] = std::min(a, b);
    }
    for (size_t v = 0; v < parent.size(); ++v) parent[v] = rootOf(parent, static_cast<int>(v));
    return parent;
}

}  // namespace

namespace {

CellParts measureColumns(const TriangleMesh& surface, const SamplingGrid& grid, const CutSurface& cut,
                         const SolidVoxels& solid, int order, const Columns& columns) {
    CellParts result;
    const int per_cell = grid.cells_per_spacing;
    result.origin = grid.origin;
    result.edges = grid.cell_size * per_cell;
    // What lies on the top planes has cells of its own, so that no point on the surface is without.
    result.count = (grid.count + Eigen::Vector3i::Constant(per_cell - 1)) / per_cell;
    result.voxels_per_cell = per_cell;
    result.order = order;

    const int voxel_count = static_cast<int>(solid.index.size());
    std::vector<long long> cell_of(voxel_count);
    for (int v = 0; v < voxel_count; ++v) {
        const Eigen::Vector3i cell = grid.voxelAt(solid.index[v]) / per_cell;
        cell_of[v] = result.cellIndex(cell);
    }
    const std::vector<int> root = connectedInCell(solid, cell_of);
    std::vector<std::vector<int>> voxels_of(voxel_count);
    for (int v = 0; v < voxel_count; ++v) voxels_of[root[v]].push_back(v);
    std::vector<int> order_of_roots;
    for (int v = 0; v < voxel_count; ++v) {
        const int column = grid.voxelAt(solid.index[v]).x() / per_cell;
        if (root[v] == v && column >= columns.first && column < columns.last) order_of_roots.push_back(v);
    }
    std::stable_sort(order_of_roots.begin(), order_of_roots.end(),
                     [&](int a, int b) { return cell_of[a] < cell_of[b]; });

    const VoxelMoments moments(grid, cut, solid, surfaceFlux(surface, grid, cut, columns, order), order);
    const int n = order + 1;
    std::vector<CellPart> parts(order_of_roots.size());
    forEachChunk(chunk_count, [&](int chunk) {
        const int total = static_cast<int>(parts.size());
        const int end = chunkBegin(chunk + 1, chunk_count, total);
        for (int p = chunkBegin(chunk, chunk_count, total); p < end; ++p) {
            CellPart& part = parts[p];
            const std::vector<int>& voxels = voxels_of[order_of_roots[p]];
            part.cell = grid.voxelAt(solid.index[voxels[0]]) / per_cell;
            bool whole = static_cast<int>(voxels.size()) == per_cell * per_cell * per_cell;
            for (const int v : voxels) whole = whole && moments.isWhole(v);
            part.fill = 1;
            if (whole) continue;
            part.moments.assign(n * n * n, 0.0);
            for (const int v : voxels) {
                const Eigen::Vector3i position = grid.voxelAt(solid.index[v]);
                moments.addTo(v, position, part.moments);
                part.voxels.push_back(position);
            }
            part.fill = part.moments[0];
            if (std::abs(part.fill - 1) > no_difference) continue;
            part.moments.clear();  // the surface only lies on the cell's border
            part.fill = 1;
        }
    });

    std::vector<int> part_of_root(voxel_count, -1);
    result.first_part.assign(result.count.prod() + 1, 0);
    for (size_t p = 0; p < parts.size(); ++p) {
        if (parts[p].fill < smallest_part) continue;
        part_of_root[order_of_roots[p]] = static_cast<int>(result.parts.size());
        ++result.first_part[result.cellIndex(parts[p].cell) + 1];
        result.parts.push_back(std::move(parts[p]));
    }
    std::partial_sum(result.first_part.begin(), result.first_part.end(), result.first_part.begin());
    for (CellPart& part : result.parts) {
        const int cell = result.cellIndex(part.cell);
        if (result.first_part[cell + 1] - result.first_part[cell] == 1) part.voxels.clear();
    }
    result.neighbours.resize(result.parts.size());
    for (const VoxelFace& face : solid.faces) {
        if (face.area < smallest_face) continue;
        const int a = part_of_root[root[face.voxels[0]]], b = part_of_root[root[face.voxels[1]]];
        if (a < 0 || b < 0 || a == b) continue;
        result.neighbours[a].push_back(b);
        result.neighbours[b].push_back(a);
    }
    for (std::vector<int>& list : result.neighbours) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    return result;
}

}  // namespace

CellParts measureCellParts(const TriangleMesh& surface, const SamplingGrid& grid, const CutSurface& cut,
                           const SolidVoxels& solid, int order) {
    return measureColumns(surface, grid, cut, solid, order, {0, grid.count.x()});
}

Result<CellParts> refineCellParts(const TriangleMesh& surface, const CellParts& coarse,
                                  const Eigen::Vector3i& lower, const Eigen::Vector3i& upper) {
    constexpr int voxels_per_cell = 2;
    SamplingGrid grid;
    grid.window = true;
    grid.cells_per_spacing = voxels_per_cell;
    grid.cell_size = coarse.edges / (2 * voxels_per_cell);
    const int first = std::min(0, lower.x()), last = std::max(coarse.count.x(), upper.x());
    const Eigen::Vector3i corner(first, lower.y(), lower.z());
    grid.origin = coarse.origin + corner.cast<double>().cwiseProduct(coarse.edges);
    grid.particle_cells = 2 * Eigen::Vector3i(last - first, upper.y() - lower.y(), upper.z() - lower.z());
    grid.count = voxels_per_cell * grid.particle_cells + Eigen::Vector3i::UnitX();
    const CutSurface cut = cutSurface(surface, grid);
    const Result<SolidVoxels> solid = fillVoxels(grid, cut);
    if (!solid) return Error{solid.error()};
    return measureColumns(surface, grid, cut, solid.value(), coarse.order,
                          {2 * (lower.x() - first), 2 * (upper.x() - first)});
}

}  // namespace sherd
