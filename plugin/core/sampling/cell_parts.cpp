#include "core/sampling/cell_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sherd {
namespace {

/// Squared distance from a point to a cube with the given lowest corner, all in edges of a cell.
double squaredDistance(const Vec3& u, const Vec3& lower, double edge) {
    const Vec3 outside = (lower - u).cwiseMax(u - lower - Vec3::Constant(edge)).cwiseMax(0.0);
    return outside.squaredNorm();
}

}  // namespace

Vec3 CellParts::centroid(const CellPart& part) const {
    Vec3 xi = Vec3::Zero();
    if (!part.moments.empty() && order > 0) {
        const std::size_t n = static_cast<std::size_t>(order) + 1;
        xi = Vec3(part.moments[1], part.moments[n], part.moments[n * n]) / part.moments[0];
    }
    return origin + (part.cell.cast<double>() + Vec3::Constant(0.5) + xi).cwiseProduct(edges);
}

int CellParts::partAt(const Vec3& x) const {
    const Vec3 u = (x - origin).cwiseQuotient(edges);
    if (!u.allFinite()) return -1;
    Eigen::Vector3i home;
    for (int d = 0; d < 3; ++d)
        home[d] = static_cast<int>(std::clamp(std::floor(u[d]), -2.0, count[d] + 1.0));
    int nearest = -1;
    double least = std::numeric_limits<double>::infinity();
    const auto consider = [&](const Eigen::Vector3i& cell) {
        if ((cell.array() < 0).any() || (cell.array() >= count.array()).any()) return;
        const int index = cellIndex(cell);
        for (int p = first_part[index]; p < first_part[index + 1]; ++p) {
            const CellPart& part = parts[p];
            double distance = std::numeric_limits<double>::infinity();
            if (part.voxels.empty()) distance = squaredDistance(u, cell.cast<double>(), 1);
            const double edge = 1.0 / voxels_per_cell;
            for (const Eigen::Vector3i& voxel : part.voxels)
                distance = std::min(distance, squaredDistance(u, voxel.cast<double>() * edge, edge));
            if (distance >= least) continue;
            least = distance;
            nearest = p;
        }
    };
    consider(home);
    if (nearest >= 0) return nearest;
    for (int k = -1; k <= 1; ++k)
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i) consider(home + Eigen::Vector3i(i, j, k));
    return nearest;
}

}  // namespace sherd
