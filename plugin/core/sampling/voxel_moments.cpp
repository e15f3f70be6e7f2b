#include "core/sampling/voxel_moments.h"

#include <algorithm>

namespace sherd {
namespace {

/// Integral of t^k over an interval, k = 0 ... n - 1.
std::vector<double> intervalMoments(double lower, double upper, int n) {
    std::vector<double> result(n);
    double low = lower, high = upper;
    for (int k = 0; k < n; ++k, low *= lower, high *= upper) result[k] = (high - low) / (k + 1);
    return result;
}

}  // namespace

VoxelMoments::VoxelMoments(const SamplingGrid& grid, const CutSurface& cut, const SolidVoxels& solid,
                           int order)
    : grid_(grid), n_(order + 1), cut_of_(solid.index.size(), -1) {
    for (size_t c = 0; c < cut.voxels.size(); ++c)
        if (solid.of_cut_voxel[c] >= 0) cut_of_[solid.of_cut_voxel[c]] = static_cast<int>(c);
    for (int k = 0; k < grid.cells_per_spacing; ++k)
        intervals_.push_back(intervalMoments(coordinate(k), coordinate(k + 1), n_));
}

VoxelMoments::VoxelMoments(const SamplingGrid& grid, const CutSurface& cut, const SolidVoxels& solid,
                           std::vector<MomentFlux> flux, int order)
    : VoxelMoments(grid, cut, solid, order) {
    flux_ = std::move(flux);
    sweepRows(cut, solid);
}

void VoxelMoments::addTo(int voxel, const Eigen::Vector3i& position, std::vector<double>& sum) const {
    const Eigen::Vector3i local = position - (position / grid_.cells_per_spacing) * grid_.cells_per_spacing;
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

/// Walks the rows along x from their upper ends down and turns the flux of every cut voxel into its moments.
/// `upper` is the flux of y^b z^c through the solid part of the face between a voxel and the one above it.
void VoxelMoments::sweepRows(const CutSurface& cut, const SolidVoxels& solid) {
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
                    passCutVoxel(flux_[voxel], i % grid_.cells_per_spacing, upper);
                else
                    passUncutVoxel(position, whole[index], upper);
            }
        }
}

void VoxelMoments::passCutVoxel(MomentFlux& flux, int local, std::vector<double>& upper) const {
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

/// A voxel without surface sets the exact values, so that rounding does not travel along the row.
void VoxelMoments::passUncutVoxel(const Eigen::Vector3i& position, bool whole,
                                  std::vector<double>& upper) const {
    const std::vector<double>&y = intervals_[position.y() % grid_.cells_per_spacing],
          &z = intervals_[position.z() % grid_.cells_per_spacing];
    for (int c = 0; c < n_; ++c)
        for (int b = 0; b < n_; ++b) upper[c * n_ + b] = whole ? y[b] * z[c] : 0;
}

}  // namespace sherd
