#include "core/mlpg/reduced/packed_stiffness.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/union_find.h"

namespace sherd {

namespace {

constexpr double largest_entry = 32767;

/// Calls visit(row, column, b) for each stored block b in the rows and columns of `blocks`, as places among
/// these.
template <class Visit>
void forEachAmong(const std::vector<int>& blocks, const PackedStiffness& stiffness, const Visit& visit) {
    std::vector<int> place_of(static_cast<std::size_t>(stiffness.blockCount()), -1);
    const int count = static_cast<int>(blocks.size());
    for (int place = 0; place < count; ++place) place_of[blocks[place]] = place;
    for (int column = 0; column < count; ++column)
        for (int b = stiffness.starts[blocks[column]]; b < stiffness.starts[blocks[column] + 1]; ++b)
            if (const int row = place_of[stiffness.rows[b]]; row >= 0) visit(row, column, b);
}

}  // namespace

PackedStiffness::PackedStiffness(const BlockMatrix& stiffness)
    : starts(stiffness.starts), rows(stiffness.rows) {
    roots.reserve(static_cast<std::size_t>(stiffness.size()));
    for (const double diagonal : diagonalOf(stiffness))
        roots.push_back(static_cast<float>(std::sqrt(diagonal / largest_entry)));
    entries.reserve(stiffness.values.size());
    for (int column = 0; column < stiffness.blockColumns(); ++column)
        for (int k = starts[column]; k < starts[column + 1]; ++k)
            for (int j = 0; j < 3; ++j) {
                const double* value = stiffness.column(column, j) + 3L * (k - starts[column]);
                for (int i = 0; i < 3; ++i)
                    entries.push_back(static_cast<std::int16_t>(std::clamp(
                        std::round(value[i] /
                                   (double(roots[3 * rows[k] + i]) * double(roots[3 * column + j]))),
                        -largest_entry, largest_entry)));
            }
}

Eigen::MatrixXf PackedStiffness::lowerPart(const std::vector<int>& blocks) const {
    const auto size = static_cast<Eigen::Index>(3 * blocks.size());
    Eigen::MatrixXf part = Eigen::MatrixXf::Zero(size, size);
    forEachAmong(blocks, *this, [&](int r, int c, int b) {
        const std::int16_t* entry = entries.data() + 9L * b;
        for (int j = 0; j < 3; ++j) {
            const float root = roots[3 * blocks[c] + j];
            float* column = &part(3L * r, 3L * c + j);
            for (int i = 0; i < 3; ++i) column[i] = entry[3 * j + i] * roots[3 * rows[b] + i] * root;
        }
    });
    return part;
}

std::vector<std::vector<int>> PackedStiffness::joined(const std::vector<int>& blocks) const {
    UnionFind groups(blocks.size());
    forEachAmong(blocks, *this, [&](int row, int column, int) { groups.unite(row, column); });
    std::vector<std::vector<int>> lists;
    std::vector<int> list_of(blocks.size(), -1);  // per root of a group
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        int& list = list_of[groups.root(static_cast<int>(i))];
        if (list < 0) {
            list = static_cast<int>(lists.size());
            lists.emplace_back();
        }
        lists[list].push_back(blocks[i]);
    }
    return lists;
}

}  // namespace sherd
