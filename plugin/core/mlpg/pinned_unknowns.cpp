#include "core/mlpg/pinned_unknowns.h"

#include <algorithm>
#include <cmath>

namespace sherd {

std::vector<int> unknownsToPin(const RigidMotions& motions, const BlockMatrix& stiffness) {
    constexpr double smallest_norm = 1e-6;
    constexpr double least_weight = 1e-3;  // of the stiffest: a component may have no stiffness
    std::vector<double> weight = diagonalOf(stiffness);
    const double largest = weight.empty() ? 0 : *std::max_element(weight.begin(), weight.end());
    for (double& w : weight) w = largest > 0 ? w / largest + least_weight : 1;
    Eigen::Matrix<double, Eigen::Dynamic, 6> rest = motions.coefficients;
    std::vector<int> pinned;
    for (int round = 0; round < 6; ++round) {
        std::vector<long> best(motions.componentCount(), -1);
        for (long unknown = 0; unknown < rest.rows(); ++unknown) {
            long& leader = best[motions.componentOfUnknown(unknown)];
            const auto holds = [&](long by) { return weight[by] * rest.row(by).squaredNorm(); };
            if (leader < 0 || holds(unknown) > holds(leader)) leader = unknown;
        }
        std::vector<Eigen::Matrix<double, 6, 1>> directions(best.size(), Eigen::Matrix<double, 6, 1>::Zero());
        for (size_t component = 0; component < best.size(); ++component) {
            const double norm = rest.row(best[component]).norm();
            if (norm < smallest_norm) continue;
            directions[component] = rest.row(best[component]).transpose() / norm;
            pinned.push_back(static_cast<int>(best[component]));
        }
        for (long unknown = 0; unknown < rest.rows(); ++unknown) {
            const auto& direction = directions[motions.componentOfUnknown(unknown)];
            rest.row(unknown) -= rest.row(unknown).dot(direction.transpose()) * direction.transpose();
        }
    }
    return pinned;
}

std::vector<ReplacedValue> pinUnknowns(BlockMatrix& matrix, const std::vector<int>& unknowns) {
    std::vector<char> pinned(matrix.size(), 0);
    for (int unknown : unknowns) pinned[unknown] = 1;
    double largest = 0;
    for (double value : matrix.values) largest = std::max(largest, std::abs(value));
    // Any positive diagonal will do. A component's own may be zero: where it is a single particle, values
    // alone make no strain.
    const double diagonal = largest > 0 ? largest : 1;
    std::vector<ReplacedValue> replaced;
    const int size = matrix.block_size;
    for (int c = 0; c < matrix.blockColumns(); ++c)
        for (int j = 0; j < size; ++j) {
            const int column = size * c + j;
            auto index = static_cast<std::size_t>(matrix.column(c, j) - matrix.values.data());
            for (int k = matrix.starts[c]; k < matrix.starts[c + 1]; ++k)
                for (int row = size * matrix.rows[k]; row < size * (matrix.rows[k] + 1); ++row, ++index) {
                    if (!pinned[column] && !pinned[row]) continue;
                    replaced.push_back({index, matrix.values[index]});
                    matrix.values[index] = row == column ? diagonal : 0;
                }
        }
    return replaced;
}

}  // namespace sherd
