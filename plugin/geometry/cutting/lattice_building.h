#pragma once

#include <sherd/triangle_mesh.h>

#include <cstdint>

#include "core/clustering/fragment_labels.h"
#include "core/sampling/discretisation.h"
#include "geometry/cutting/label_lattice.h"

namespace sherd {

struct LatticeSettings {
    double spacing = 0;    ///< m
    double jitter = 0.15;  ///< nodes are moved by up to this fraction of the spacing along each axis
    std::uint64_t seed = 0;
};

/// Lays a lattice over the solid and gives each node near it the label that is densest there (see
/// label_densities.h). Nodes that no particle's kernel reaches take the label of the nearest node that has
/// one.
LabelLattice buildLabelLattice(const TriangleMesh& surface, const Discretisation& solid,
                               const FragmentLabels& labels, const LatticeSettings& settings);

}  // namespace sherd
