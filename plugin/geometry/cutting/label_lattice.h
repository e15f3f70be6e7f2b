#pragma once

#include <sherd/triangle_mesh.h>

#include <cstdint>
#include <vector>

#include "core/clustering/fragment_labels.h"
#include "core/sampling/discretisation.h"

namespace sherd {

struct LatticeSettings {
    double spacing = 0;    ///< m
    double jitter = 0.15;  ///< nodes are moved by up to this fraction of the spacing along each axis
    std::uint64_t seed = 0;
};

/// Which fragment the space in and around a solid belongs to, on the nodes of a jittered cubic lattice. Node
/// (i, j, k) has index i + size.x (j + size.y k); cell (i, j, k) has the index of its lowest node.
struct LabelLattice {
    double spacing = 0;  ///< m
    Vec3 origin = Vec3::Zero();
    Eigen::Vector3i size = Eigen::Vector3i::Zero();  ///< nodes along each axis
    std::vector<Vec3> nodes;
    std::vector<int> labels;         ///< #nodes; -1 on nodes of no active cell
    std::vector<char> active_cells;  ///< #nodes; cells that the solid can touch

    /// #labels, 1: the particles' shares say where the fragment's cracks are, so that smoothing would only
    /// move them.
    std::vector<char> sharp;
    bool isSharp(int node) const {
        return labels[node] >= 0 && labels[node] < static_cast<int>(sharp.size()) && sharp[labels[node]];
    }

    /// Density of one fragment at a node, a part of 1 about: that of the densest of its clusters.
    double density(int node, int label) const;

    int index(int i, int j, int k) const { return i + size.x() * (j + size.y() * k); }

    struct Density {
        int label;
        double value;
        int next;  ///< in `densities`, or -1
    };
    std::vector<int> first_density;  ///< #nodes, or -1
    std::vector<Density> densities;
};

/// Every particle spreads its volume over a smooth kernel; the label with the largest sum wins a node. A
/// particle whose own label would lose at its own position is weighted up until it wins, so that one-particle
/// fragments survive the smoothing.
LabelLattice buildLabelLattice(const TriangleMesh& surface, const Discretisation& solid,
                               const FragmentLabels& labels, const LatticeSettings& settings);

/// Somewhat less than the spacing of the particles where fragments meet, and no more than `largest` (m; 0:
/// any), but no finer than about `largest_node_count` nodes allow, m.
double latticeSpacing(const TriangleMesh& surface, const Discretisation& solid, const FragmentLabels& labels,
                      double largest_node_count, double largest = 0);

}  // namespace sherd
