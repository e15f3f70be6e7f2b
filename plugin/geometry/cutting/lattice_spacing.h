#pragma once

#include <sherd/triangle_mesh.h>

#include "core/clustering/fragment_labels.h"
#include "core/sampling/discretisation.h"

namespace sherd {

constexpr double most_lattice_nodes = 2e6;  ///< of a lattice that cuts

/// Spacing of a lattice over particles that are `particle_spacing` apart, m: somewhat less than that, at most
/// `largest` (m; 0: no limit), but no finer than about `largest_node_count` nodes allow.
double latticeSpacing(const TriangleMesh& surface, double particle_spacing, double largest_node_count,
                      double largest = 0);

/// How far particles are apart where fragments meet, m.
double spacingAtBorders(const Discretisation& solid, const FragmentLabels& labels);

}  // namespace sherd
