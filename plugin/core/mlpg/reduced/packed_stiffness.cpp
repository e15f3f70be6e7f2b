#include "core/mlpg/reduced/packed_stiffness.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/numerics/union_find.h"
#include "core/numerics/wide_vectors.h"

namespace sherd {

namespace {

constexpr float largest_entry = 32767;

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

// Vectors have four numbers for each three unknowns, the last of which is zero.
Eigen::VectorXf inFours(const Eigen::VectorXf& threes) {
    Eigen::Matrix4Xf fours = Eigen::Matrix4Xf::Zero(4, threes.size() / 3);
    fours.topRows<3>() = threes.reshaped(3, fours.cols());
    return fours.reshaped();
}

Eigen::VectorXf inThrees(const Eigen::VectorXf& fours) {
    return fours.reshaped(4, fours.size() / 4).topRows<3>().reshaped();
}

using Four = float __attribute__((vector_size(16)));
using FourInts = std::int32_t __attribute__((vector_size(16)));
using FourShorts = std::int16_t __attribute__((vector_size(8)));

SHERD_INLINED Four load(const float* x) {
    Four four;
    std::memcpy(&four, x, sizeof four);
    return four;
}

SHERD_INLINED Four widened(const std::int16_t* entry) {
    FourShorts four;
    std::memcpy(&four, entry, sizeof four);
    return __builtin_convertvector(__builtin_convertvector(four, FourInts), Four);
}

/// The columns of a block.
struct BlockColumns {
    Four first, second, third;
};
SHERD_INLINED BlockColumns columnsOf(const std::int16_t* entry) {
    const Four last = widened(entry + 5);  // none is read beyond the block
    return {widened(entry), widened(entry + 3), __builtin_shufflevector(last, last, 1, 2, 3, 0)};
}

/// sum += B x of the blocks from `b` to `end`, x being the three numbers of their column.
SHERD_INLINED void addBlocks(const PackedStiffness& stiffness, int b, int end, const float* x, float* sum) {
    const Four x0 = {x[0], x[0], x[0], 0}, x1 = {x[1], x[1], x[1], 0}, x2 = {x[2], x[2], x[2], 0};
    for (; b < end; ++b) {
        const BlockColumns block = columnsOf(stiffness.entries.data() + 9L * b);
        float* row = sum + 4L * stiffness.rows[b];
        const Four more = load(row) + (block.first * x0 + block.second * x1 + block.third * x2);
        std::memcpy(row, &more, sizeof more);
    }
}

/// sum += B^T x of these, for the three numbers of their column.
SHERD_INLINED void addTransposedBlocks(const PackedStiffness& stiffness, int b, int end, const float* x,
                                       float* sum) {
    Four of_first = {}, of_second = {}, of_third = {};
    for (; b < end; ++b) {
        const BlockColumns block = columnsOf(stiffness.entries.data() + 9L * b);
        const Four row = load(x + 4L * stiffness.rows[b]);
        of_first += block.first * row;
        of_second += block.second * row;
        of_third += block.third * row;
    }
    sum[0] += of_first[0] + of_first[1] + of_first[2];
    sum[1] += of_second[0] + of_second[1] + of_second[2];
    sum[2] += of_third[0] + of_third[1] + of_third[2];
}

/// What a diagonal block has below its diagonal.
struct BelowDiagonal {
    float e10, e20, e21;
};
SHERD_INLINED BelowDiagonal belowDiagonal(const PackedStiffness& stiffness, int column) {
    const std::int16_t* entry = stiffness.entries.data() + 9L * stiffness.starts[column];
    return {float(entry[1]), float(entry[2]), float(entry[5])};
}

// Of the symmetric matrix of the entries, L + D + L^T: all of D is `largest_entry`. Vectors have a number
// more than the matrix has rows.

SHERD_WIDE_VECTORS
void setToProduct(const PackedStiffness& stiffness, const float* x, float* product) {
    const int count = stiffness.blockCount();
    for (long i = 0; i < 4L * count; ++i) product[i] = largest_entry * x[i];
    for (int column = 0; column < count; ++column) {
        const BelowDiagonal below = belowDiagonal(stiffness, column);
        const float* of_column = x + 4L * column;
        float* own = product + 4L * column;
        own[0] += below.e10 * of_column[1] + below.e20 * of_column[2];
        own[1] += below.e10 * of_column[0] + below.e21 * of_column[2];
        own[2] += below.e20 * of_column[0] + below.e21 * of_column[1];
        const int first = stiffness.starts[column] + 1, end = stiffness.starts[column + 1];
        addBlocks(stiffness, first, end, of_column, product);
        addTransposedBlocks(stiffness, first, end, x, own);
    }
}

/// f = (D + L)^-1 f.
SHERD_WIDE_VECTORS
void solveLower(const PackedStiffness& stiffness, float* f) {
    constexpr float inverse = 1 / largest_entry;
    for (int column = 0; column < stiffness.blockCount(); ++column) {
        const BelowDiagonal below = belowDiagonal(stiffness, column);
        float* own = f + 4L * column;
        own[0] *= inverse;
        own[1] = inverse * (own[1] - below.e10 * own[0]);
        own[2] = inverse * (own[2] - below.e20 * own[0] - below.e21 * own[1]);
        const float taken[] = {-own[0], -own[1], -own[2]};
        addBlocks(stiffness, stiffness.starts[column] + 1, stiffness.starts[column + 1], taken, f);
    }
}

/// f = (D + L)^-T f.
SHERD_WIDE_VECTORS
void solveUpper(const PackedStiffness& stiffness, float* f) {
    constexpr float inverse = 1 / largest_entry;
    for (int column = stiffness.blockCount() - 1; column >= 0; --column) {
        const BelowDiagonal below = belowDiagonal(stiffness, column);
        float* own = f + 4L * column;
        float sum[] = {0, 0, 0};
        addTransposedBlocks(stiffness, stiffness.starts[column] + 1, stiffness.starts[column + 1], f, sum);
        own[2] = inverse * (own[2] - sum[2]);
        own[1] = inverse * (own[1] - sum[1] - below.e21 * own[2]);
        own[0] = inverse * (own[0] - sum[0] - below.e10 * own[1] - below.e20 * own[2]);
    }
}

}  // namespace

PackedStiffness::PackedStiffness(const BlockMatrix& stiffness)
    : starts(stiffness.starts), rows(stiffness.rows) {
    roots.reserve(static_cast<std::size_t>(stiffness.size()));
    for (const double diagonal : diagonalOf(stiffness))
        roots.push_back(static_cast<float>(std::sqrt(diagonal / double(largest_entry))));
    entries.reserve(stiffness.values.size());
    for (int column = 0; column < stiffness.blockColumns(); ++column)
        for (int k = starts[column]; k < starts[column + 1]; ++k)
            for (int j = 0; j < 3; ++j) {
                const double* value = stiffness.column(column, j) + 3L * (k - starts[column]);
                for (int i = 0; i < 3; ++i)
                    entries.push_back(static_cast<std::int16_t>(std::clamp(
                        std::round(value[i] /
                                   (double(roots[3 * rows[k] + i]) * double(roots[3 * column + j]))),
                        -double(largest_entry), double(largest_entry))));
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

Eigen::VectorXf PackedStiffness::times(const Eigen::VectorXf& unknowns) const {
    const Eigen::Map<const Eigen::ArrayXf> scale(roots.data(), unknowns.size());
    const Eigen::VectorXf x = inFours(scale * unknowns.array());
    Eigen::VectorXf product(x.size());
    setToProduct(*this, x.data(), product.data());
    return scale * inThrees(product).array();
}

Eigen::VectorXf PackedStiffness::solveRoughly(const Eigen::VectorXf& forces, int rounds) const {
    const Eigen::Map<const Eigen::ArrayXf> scale(roots.data(), forces.size());
    // Of A y = (D + L)^-1 f with A = (D + L)^-1 K (D + L)^-T, a product with which is two triangular solves.
    Eigen::VectorXf rest = inFours(forces.array() / scale);
    solveLower(*this, rest.data());
    Eigen::VectorXf found = Eigen::VectorXf::Zero(rest.size()), direction = rest, step, change;
    double squared = double(rest.squaredNorm());
    for (int round = 0; round < rounds && squared > 0; ++round) {
        step = direction;
        solveUpper(*this, step.data());
        change = direction - largest_entry * step;
        solveLower(*this, change.data());
        change += step;
        const auto length = float(squared / double(direction.dot(change)));
        found += length * step;
        rest -= length * change;
        const double left = double(rest.squaredNorm());
        direction = rest + float(left / squared) * direction;
        squared = left;
    }
    return inThrees(found).array() / scale;
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
