#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/linear_algebra/block_graph.h"

namespace sherd {

/// Cuts a graph whose vertices lie on a lattice and share edges with near ones by planes between layers of
/// the lattice, again and again (nested dissection, George 1973). Returns the part of each vertex: parts that
/// share edges are to be eliminated in the order of their numbers, so that what lies across a cut comes after
/// what it parts. `places`: of the vertices on the lattice.
std::vector<int> nestedDissection(const BlockGraph& graph, const std::vector<Eigen::Vector3i>& places);

}  // namespace sherd
