#pragma once

#include <sherd/types.h>

#include <vector>

#include "geometry/cutting/node_densities.h"

namespace sherd {

constexpr int lattice_margin = 3;  ///< cells of air around the solid's box

/// Which fragment the space in and around a solid belongs to, on the nodes of a jittered cubic lattice. Node
/// (i, j, k) has index i + size.x (j + size.y k); cell (i, j, k) has the index of its lowest node.
struct LabelLattice {
    double spacing = 0;  ///< m
    double jitter = 0;   ///< by how much nodes are moved at most along each axis, of the spacing
    Vec3 origin = Vec3::Zero();
    Eigen::Vector3i size = Eigen::Vector3i::Zero();  ///< nodes along each axis
    std::vector<Vec3> nodes;                         ///< m; those with a label
    std::vector<int> labels;                         ///< #nodes; -1 on nodes of no active cell
    std::vector<char> active_cells;                  ///< #nodes; 1: the solid may reach into the cell
    NodeDensities densities;                         ///< from which the labels were chosen

    /// #labels, 1: the runners-up of its particles, or a guide field, say where the label's cracks are;
    /// smoothing would only move them away.
    std::vector<char> sharp;
    bool isSharp(int node) const {
        return labels[node] >= 0 && labels[node] < static_cast<int>(sharp.size()) && sharp[labels[node]];
    }

    int index(int i, int j, int k) const { return i + size.x() * (j + size.y() * k); }

    /// Calls visit(i, j, k) for every cell.
    template <class Visit>
    void forEachCell(const Visit& visit) const {
        for (int k = 0; k + 1 < size.z(); ++k)
            for (int j = 0; j + 1 < size.y(); ++j)
                for (int i = 0; i + 1 < size.x(); ++i) visit(i, j, k);
    }

    /// Index of corner 0 ... 7 of a cell.
    int cornerOf(int i, int j, int k, int corner) const {
        return index(i + corner % 2, j + corner / 2 % 2, k + corner / 4);
    }
};

}  // namespace sherd
