#include "core/mlpg/reduced/packed_stiffness.h"

#include <algorithm>
#include <cmath>

namespace sherd {

namespace {

constexpr double largest_entry = 32767;

}  // namespace

PackedStiffness::PackedStiffness(const SparseMatrix& lower) : starts(1, 0) {
    roots.reserve(static_cast<std::size_t>(lower.size));
    for (int column = 0; column < lower.size; ++column) {
        const double diagonal = lower.values[lower.starts[column] + column % 3];
        roots.push_back(static_cast<float>(std::sqrt(diagonal / largest_entry)));
    }
    for (int column = 0; column < lower.size; column += 3) {
        const int first = lower.starts[column], height = lower.starts[column + 1] - first;
        for (int k = 0; k < height; k += 3) {
            const int row = lower.indices[first + k];
            rows.push_back(row / 3);
            for (int j = 0; j < 3; ++j)
                for (int i = 0; i < 3; ++i)
                    entries.push_back(static_cast<std::int16_t>(
                        std::clamp(std::round(lower.values[lower.starts[column + j] + k + i] /
                                              (double(roots[row + i]) * double(roots[column + j]))),
                                   -largest_entry, largest_entry)));
        }
        starts.push_back(static_cast<int>(rows.size()));
    }
}

Eigen::MatrixXf PackedStiffness::lowerPart(const std::vector<int>& blocks,
                                           const std::vector<int>& place_of) const {
    const auto size = static_cast<Eigen::Index>(3 * blocks.size());
    Eigen::MatrixXf part = Eigen::MatrixXf::Zero(size, size);
    for (std::size_t c = 0; c < blocks.size(); ++c)
        for (int b = starts[blocks[c]]; b < starts[blocks[c] + 1]; ++b) {
            const int r = place_of[rows[b]];
            if (r < 0) continue;
            const std::int16_t* entry = entries.data() + 9L * b;
            for (int j = 0; j < 3; ++j) {
                const float root = roots[3 * blocks[c] + j];
                float* column = &part(3L * r, static_cast<Eigen::Index>(3 * c + j));
                for (int i = 0; i < 3; ++i) column[i] = entry[3 * j + i] * roots[3 * rows[b] + i] * root;
            }
        }
    return part;
}

}  // namespace sherd
