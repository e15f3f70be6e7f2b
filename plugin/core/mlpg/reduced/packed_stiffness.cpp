#include "core/mlpg/reduced/packed_stiffness.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/union_find.h"

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

/// The symmetric matrix of the entries, L + D + L^T: all of D is `largest_entry`.
class Entries {
  public:
    explicit Entries(const PackedStiffness& stiffness) : stiffness_(stiffness) {}

    Eigen::VectorXf times(const Eigen::VectorXf& x) const {
        Eigen::VectorXf product = largest_entry * x;
        for (int column = 0; column < stiffness_.blockCount(); ++column) {
            const Below below = belowDiagonal(column);
            const float* of_column = &x[3L * column];
            float* own = &product[3L * column];
            own[0] += below.e10 * of_column[1] + below.e20 * of_column[2];
            own[1] += below.e10 * of_column[0] + below.e21 * of_column[2];
            own[2] += below.e20 * of_column[0] + below.e21 * of_column[1];
            addBlocks(column, of_column, product);
            addTransposedBlocks(column, x, own);
        }
        return product;
    }

    /// (D + L)^-1 f.
    Eigen::VectorXf solveLower(Eigen::VectorXf f) const {
        for (int column = 0; column < stiffness_.blockCount(); ++column) {
            const Below below = belowDiagonal(column);
            float* own = &f[3L * column];
            own[0] *= inverse;
            own[1] = inverse * (own[1] - below.e10 * own[0]);
            own[2] = inverse * (own[2] - below.e20 * own[0] - below.e21 * own[1]);
            const float taken[] = {-own[0], -own[1], -own[2]};
            addBlocks(column, taken, f);
        }
        return f;
    }

    /// (D + L)^-T f.
    Eigen::VectorXf solveUpper(Eigen::VectorXf f) const {
        for (int column = stiffness_.blockCount() - 1; column >= 0; --column) {
            const Below below = belowDiagonal(column);
            float* own = &f[3L * column];
            float sum[] = {0, 0, 0};
            addTransposedBlocks(column, f, sum);
            own[2] = inverse * (own[2] - sum[2]);
            own[1] = inverse * (own[1] - sum[1] - below.e21 * own[2]);
            own[0] = inverse * (own[0] - sum[0] - below.e10 * own[1] - below.e20 * own[2]);
        }
        return f;
    }

  private:
    static constexpr float inverse = 1 / largest_entry;

    /// In the diagonal block.
    struct Below {
        float e10, e20, e21;
    };
    Below belowDiagonal(int column) const {
        const std::int16_t* entry = stiffness_.entries.data() + 9L * stiffness_.starts[column];
        return {float(entry[1]), float(entry[2]), float(entry[5])};
    }
    /// sum += B x of the blocks below the diagonal one of a column, x being its three numbers.
    void addBlocks(int column, const float* x, Eigen::VectorXf& sum) const {
        for (int b = stiffness_.starts[column] + 1; b < stiffness_.starts[column + 1]; ++b) {
            const std::int16_t* entry = stiffness_.entries.data() + 9L * b;
            float* row = &sum[3L * stiffness_.rows[b]];
            for (int i = 0; i < 3; ++i)
                row[i] += float(entry[i]) * x[0] + float(entry[3 + i]) * x[1] + float(entry[6 + i]) * x[2];
        }
    }
    /// sum += B^T x of these, for the three numbers of the column.
    void addTransposedBlocks(int column, const Eigen::VectorXf& x, float* sum) const {
        for (int b = stiffness_.starts[column] + 1; b < stiffness_.starts[column + 1]; ++b) {
            const std::int16_t* entry = stiffness_.entries.data() + 9L * b;
            const float* row = &x[3L * stiffness_.rows[b]];
            for (int j = 0; j < 3; ++j)
                sum[j] += float(entry[3 * j]) * row[0] + float(entry[3 * j + 1]) * row[1] +
                          float(entry[3 * j + 2]) * row[2];
        }
    }

    const PackedStiffness& stiffness_;
};

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
    const Eigen::Map<const Eigen::ArrayXf> scale(roots.data(), static_cast<Eigen::Index>(roots.size()));
    return scale * Entries(*this).times(scale * unknowns.array()).array();
}

Eigen::VectorXf PackedStiffness::solveRoughly(const Eigen::VectorXf& forces, int rounds) const {
    const Eigen::Map<const Eigen::ArrayXf> scale(roots.data(), static_cast<Eigen::Index>(roots.size()));
    const Entries entries(*this);
    // Of A y = (D + L)^-1 f with A = (D + L)^-1 K (D + L)^-T, a product with which is two triangular solves.
    Eigen::VectorXf found = Eigen::VectorXf::Zero(forces.size());
    Eigen::VectorXf rest = entries.solveLower(forces.array() / scale), direction = rest;
    double squared = double(rest.squaredNorm());
    for (int round = 0; round < rounds && squared > 0; ++round) {
        const Eigen::VectorXf step = entries.solveUpper(direction);
        const Eigen::VectorXf change = step + entries.solveLower(direction - largest_entry * step);
        const auto length = float(squared / double(direction.dot(change)));
        found += length * step;
        rest -= length * change;
        const double left = double(rest.squaredNorm());
        direction = rest + float(left / squared) * direction;
        squared = left;
    }
    return found.array() / scale;
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
