#pragma once

#include <cstddef>
#include <vector>

namespace sherd {

/// A symmetric matrix in compressed columns of square blocks (BCSC), from the diagonal blocks (complete)
/// downwards. Block column c has the blocks starts[c] .. starts[c + 1] - 1, in ascending order of their rows;
/// its values are those of a dense matrix of its blocks, one below the other, column by column. One index
/// serves a block, and the numbers of a scalar column lie together.
struct BlockMatrix {
    int block_size = 3;
    std::vector<int> starts{0};  ///< #block columns + 1
    std::vector<int> rows;       ///< per block: its block row
    std::vector<double> values;  ///< block_size squared a block

    int blockColumns() const { return static_cast<int>(starts.size()) - 1; }
    int size() const { return block_size * blockColumns(); }
    /// Numbers in each scalar column of a block column.
    long height(int block_column) const {
        return static_cast<long>(block_size) * (starts[block_column + 1] - starts[block_column]);
    }
    /// The first number of scalar column j of a block column, once there are values.
    double* column(int block_column, int j) { return values.data() + offset(block_column, j); }
    const double* column(int block_column, int j) const { return values.data() + offset(block_column, j); }

    /// Adds a block column, all zero, with blocks in these rows: ascending, the diagonal one first.
    void addColumn(const std::vector<int>& block_rows) {
        rows.insert(rows.end(), block_rows.begin(), block_rows.end());
        starts.push_back(static_cast<int>(rows.size()));
    }
    /// After the last column was added.
    void setZero() { values.assign(static_cast<std::size_t>(block_size * block_size) * rows.size(), 0.0); }

  private:
    long offset(int block_column, int j) const {
        return static_cast<long>(block_size * block_size) * starts[block_column] + j * height(block_column);
    }
};

/// #size.
inline std::vector<double> diagonalOf(const BlockMatrix& matrix) {
    std::vector<double> diagonal;
    diagonal.reserve(static_cast<std::size_t>(matrix.size()));
    for (int c = 0; c < matrix.blockColumns(); ++c)
        for (int j = 0; j < matrix.block_size; ++j) diagonal.push_back(matrix.column(c, j)[j]);
    return diagonal;
}

}  // namespace sherd
