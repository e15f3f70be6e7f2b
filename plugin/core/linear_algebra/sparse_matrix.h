#pragma once

#include <cstddef>
#include <vector>

namespace sherd {

/// A square sparse matrix in compressed columns (CSC) or compressed rows (CSR); each function states which it
/// takes or returns. Column (or row) l holds entries starts[l] .. starts[l + 1] - 1, in ascending order of
/// index.
struct SparseMatrix {
    int size = 0;
    std::vector<int> starts;     ///< size + 1
    std::vector<int> indices;    ///< #entries: rows in CSC, columns in CSR
    std::vector<double> values;  ///< #entries
};

/// #size; 0 where nothing is stored.
inline std::vector<double> diagonalOf(const SparseMatrix& matrix) {
    std::vector<double> diagonal(static_cast<std::size_t>(matrix.size), 0.0);
    for (int line = 0; line < matrix.size; ++line)
        for (int k = matrix.starts[line]; k < matrix.starts[line + 1]; ++k)
            if (matrix.indices[k] == line) diagonal[line] = matrix.values[k];
    return diagonal;
}

}  // namespace sherd
