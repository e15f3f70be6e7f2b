#include "core/sampling/voxel_points.h"

#include <sherd/settings.h>

#include <algorithm>
#include <cmath>

#include "core/numerics/wide_vectors.h"

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

constexpr int point_count = 8;  // of a voxel

static_assert(most_powers <= wide_count);

/// Powers of the points' coordinates; of z times the weight.
struct PointPowers {
    WideDoubles x[point_count];  // and zeros
    double y[most_powers][point_count], z[most_powers][point_count];
};

/// sum[(c N + b) N + a] += sum over points of x^a y^b z^c, with N powers a direction.
SHERD_WIDE_VECTORS
void addProducts(const PointPowers& points, int powers, double* sum) {
    for (int c = 0; c < powers; ++c)
        for (int b = 0; b < powers; ++b, sum += powers) {
            WideDoubles own = {};
            for (int k = 0; k < point_count; ++k) own += points.y[b][k] * points.z[c][k] * points.x[k];
            for (int a = 0; a < powers; ++a) sum[a] += own[a];
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
    PointPowers points;
    const int powers = order + 1;
    for (int corner = 0; corner < point_count; ++corner) {
        const Vec3 sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
        const Vec3 x = (middle + root * sign) / per_cell - Vec3::Constant(0.5);
        double along_x = 1, along_y = 1, along_z = weight;
        points.x[corner] = WideDoubles{};
        for (int a = 0; a < powers; ++a) {
            points.x[corner][a] = along_x;
            points.y[a][corner] = along_y;
            points.z[a][corner] = along_z;
            along_x *= x.x();
            along_y *= x.y();
            along_z *= x.z();
        }
    }
    addProducts(points, powers, sum.data());
}

}  // namespace sherd
