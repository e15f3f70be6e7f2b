#include "core/sampling/voxel_points.h"

#include <sherd/settings.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sherd {
namespace {

constexpr int most_powers = 2 * largest_spline_degree + 1;  // a direction

/// Lower triangular L with L L^T = `second` as far as rounding left that positive, in edges of a voxel.
Mat3 rootOf(const Mat3& second) {
    constexpr double no_spread = 1e-12;  // along an axis, squared
    Mat3 root = Mat3::Zero();
    for (int j = 0; j < 3; ++j) {
        const double squared = second(j, j) - root.row(j).head(j).squaredNorm();
        if (!(squared > no_spread)) continue;
        root(j, j) = std::sqrt(std::min(squared, 0.25));  // half of it at either end of the voxel
        for (int i = j + 1; i < 3; ++i)
            root(i, j) = (second(i, j) - root.row(i).head(j).dot(root.row(j).head(j))) / root(j, j);
    }
    return root;
}

void addPoint(const Vec3& x, double weight, int powers, std::vector<double>& sum) {
    std::array<double, most_powers> along_x;
    along_x[0] = 1;
    for (int a = 1; a < powers; ++a) along_x[a] = along_x[a - 1] * x.x();
    double* target = sum.data();
    double of_z = weight;
    for (int c = 0; c < powers; ++c, of_z *= x.z()) {
        double of_y = of_z;
        for (int b = 0; b < powers; ++b, of_y *= x.y())
            for (int a = 0; a < powers; ++a) *target++ += of_y * along_x[a];
    }
}

}  // namespace

void addVoxelPoints(const RawMoments& voxel, const Eigen::Vector3i& local, int per_cell, int order,
                    std::vector<double>& sum) {
    if (!(voxel.volume > 0)) return;  // rounding
    const Vec3 centre = (voxel.first / voxel.volume).cwiseMax(-0.5).cwiseMin(0.5);
    const Mat3 root = rootOf(voxel.second / voxel.volume - centre * centre.transpose());
    const Vec3 middle = local.cast<double>() + Vec3::Constant(0.5) + centre;
    const double weight = voxel.volume / (8 * per_cell * per_cell * per_cell);
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
        addPoint((middle + root * sign) / per_cell - Vec3::Constant(0.5), weight, order + 1, sum);
    }
}

}  // namespace sherd
