#pragma once

#include <optional>

#include "geometry/cutting/label_lattice.h"

namespace sherd {

/// Where on the lattice edge between two nodes the crack between them crosses it, from 0 at `a` to 1 at `b`;
/// none if no crack parts them.
std::optional<double> crackOnEdge(const LabelLattice& lattice, int a, int b);

/// Where the cracks between three nodes meet in the plane of the nodes, m; none if they do not.
std::optional<Vec3> crackJunction(const LabelLattice& lattice, int a, int b, int c);

}  // namespace sherd
