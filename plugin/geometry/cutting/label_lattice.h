#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/clustering/crack_tree.h"
#include "geometry/cutting/lattice_layout.h"
#include "geometry/cutting/node_densities.h"

namespace sherd {

/// Which fragment the space in and around a solid belongs to, on the nodes of a jittered cubic lattice.
struct LabelLattice : LatticeGrid {
    std::shared_ptr<const LatticeLayout> layout;  ///< which of its nodes and cells are of use
    std::vector<Vec3> nodes;                      ///< m; those with a label
    std::vector<int> labels;                      ///< #nodes; -1 on nodes of no active cell
    NodeDensities densities;                      ///< from which the labels were chosen
    double smallest_edge_place = 0.15;            ///< see clampToEdge

    // Where crack planes say exactly where cracks run; else empty. Then there are no densities.
    std::shared_ptr<const CrackTree> cracks;
    std::vector<int> parts;  ///< #nodes, of the tree; -1 on nodes of no active cell

    /// #labels, 1: the runners-up of its particles, or a guide field, say where the label's cracks are;
    /// smoothing would only move them away.
    std::vector<char> sharp;
    bool isSharp(int node) const {
        return labels[node] >= 0 && labels[node] < static_cast<int>(sharp.size()) && sharp[labels[node]];
    }
};

/// Where a node is jittered to. Each attempt is another random place.
Vec3 placeOfNode(const LatticeGrid& grid, int node, std::uint64_t seed, int attempt = 0);

}  // namespace sherd
