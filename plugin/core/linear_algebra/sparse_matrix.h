#pragma once

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

}  // namespace sherd
