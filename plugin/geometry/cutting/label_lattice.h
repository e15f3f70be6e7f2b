#pragma once

#include <memory>
#include <vector>

#include "geometry/cutting/lattice_layout.h"
#include "geometry/cutting/node_densities.h"

namespace sherd {

/// Which fragment the space in and around a solid belongs to, on the nodes of a jittered cubic lattice.
struct LabelLattice : LatticeGrid {
    std::shared_ptr<const LatticeLayout> layout;  ///< which of its nodes and cells are of use
    std::vector<Vec3> nodes;                      ///< m; those with a label
    std::vector<int> labels;                      ///< #nodes; -1 on nodes of no active cell
    NodeDensities densities;                      ///< from which the labels were chosen

    /// #labels, 1: the runners-up of its particles, or a guide field, say where the label's cracks are;
    /// smoothing would only move them away.
    std::vector<char> sharp;
    bool isSharp(int node) const {
        return labels[node] >= 0 && labels[node] < static_cast<int>(sharp.size()) && sharp[labels[node]];
    }
};

}  // namespace sherd
