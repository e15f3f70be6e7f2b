#pragma once

#include <vector>

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

/// `starts`, `rows`: of the block columns, from the diagonal downwards, as of a BlockMatrix.
BlockGraph blockGraph(const std::vector<int>& starts, const std::vector<int>& rows);

}  // namespace sherd
