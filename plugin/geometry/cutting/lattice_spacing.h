#pragma once

#include <sherd/triangle_mesh.h>

#include "core/clustering/fragment_labels.h"
#include "core/sampling/discretisation.h"

namespace sherd {

/// Spacing of a lattice, m: somewhat less than that of the particles where fragments meet, at most `largest`
/// (m; 0: no limit), but no finer than about `largest_node_count` nodes allow.
double latticeSpacing(const TriangleMesh& surface, const Discretisation& solid, const FragmentLabels& labels,
                      double largest_node_count, double largest = 0);

}  // namespace sherd
