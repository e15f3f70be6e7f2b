#include "core/mlpg/pinned_unknowns.h"

#include <algorithm>

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
    const int size = matrix.block_size;
    std::vector<char> pinned(matrix.size(), 0), pinned_block(matrix.blockColumns(), 0);
    for (const int unknown : unknowns) pinned[unknown] = pinned_block[unknown / size] = 1;
    // Any positive diagonal will do. A component's own may be zero: where it is a single particle, values
    // alone make no strain.
    const std::vector<double> own = diagonalOf(matrix);
    const double largest = own.empty() ? 0 : *std::max_element(own.begin(), own.end());
    const double diagonal = largest > 0 ? largest : 1;
    std::vector<ReplacedValue> replaced;
    for (int c = 0; c < matrix.blockColumns(); ++c)
        for (int k = matrix.starts[c]; k < matrix.starts[c + 1]; ++k) {
            if (!pinned_block[c] && !pinned_block[matrix.rows[k]]) continue;
            for (int j = 0; j < size; ++j)
                for (int i = 0; i < size; ++i) {
                    const int column = size * c + j, row = size * matrix.rows[k] + i;
                    if (!pinned[column] && !pinned[row]) continue;
                    double& value = matrix.column(c, j)[size * (k - matrix.starts[c]) + i];
                    replaced.push_back({static_cast<std::size_t>(&value - matrix.values.data()), value});
                    value = row == column ? diagonal : 0;
                }
        }
    return replaced;
}

}  // namespace sherd
