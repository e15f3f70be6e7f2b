#pragma once

#include <vector>

#include "core/linear_algebra/sparse_matrix.h"

namespace sherd {

/// Which blocks of a symmetric matrix differ from zero, as a graph: every block column is a vertex, and the
/// edges of a vertex name the other columns that it shares a block with.
struct BlockGraph {
    std::vector<int> starts;      ///< #vertices + 1
    std::vector<int> neighbours;  ///< per edge: ascending for each vertex
    std::vector<int>
        positions;  ///< per edge: place of its block in the column of the lower of its two vertices

    int size() const { return static_cast<int>(starts.size()) - 1; }
};

/// Of a matrix in CSC, in blocks of `block_size` squared with equal patterns, from the diagonal blocks
/// (complete) downwards. Values are not used.
BlockGraph blockGraph(const SparseMatrix& lower, int block_size);

}  // namespace sherd
