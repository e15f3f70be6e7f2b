#pragma once

#include <array>
#include <vector>

namespace sherd {

using Triangle = std::array<int, 3>;

/// The undirected edges of any set of triangles, and the half-edges along each. Half-edge 3 t + i runs from
/// corner i of triangle t to its next corner.
struct EdgeTable {
    std::vector<std::array<int, 2>> edges;        ///< #E, lower vertex first, ascending
    std::vector<std::array<int, 3>> of_triangle;  ///< #T, the edge of half-edge 3 t + i
    std::vector<int> first_use;                   ///< #E + 1, offsets into `uses`
    std::vector<int> uses;                        ///< half-edges, grouped by edge
};

/// Linear time; vertices are numbered below `vertex_count`.
EdgeTable buildEdgeTable(const std::vector<Triangle>& triangles, int vertex_count);

}  // namespace sherd
