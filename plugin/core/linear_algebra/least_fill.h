#pragma once

#include <Eigen/Core>

#include "core/linear_algebra/elimination_tree.h"

namespace sherd {

/// The better of two orders in which to eliminate the vertices of a graph: approximate minimum degree
/// (Amestoy, Davis and Duff 2004), and the same within the parts of a nested dissection by the `places` of
/// the vertices on a lattice; the first where there are no places. Empty for a graph with vertices if there
/// is not enough memory.
EliminationTree leastFill(const BlockGraph& graph, const std::vector<Eigen::Vector3i>& places);

}  // namespace sherd
