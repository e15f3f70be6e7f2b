#pragma once

#include <array>
#include <string>

#include "geometry/fragment_surfaces.h"

namespace sherd::fragment_support {

using Corner = std::array<double, 3>;

/// A triangle by the coordinates of its corners, from the lowest on: the same for both sides of a crack but for the turn.
std::array<Corner, 3> cornersOf(const TriangleMesh& mesh, std::size_t t, bool reversed);

/// What is wrong with the pieces of a body: a fault of one of them (see piece_checks.h), volumes that do not add up to
/// a thousandth, or a crack triangle without exactly one partner, turned the other way round and equal bit for bit, in
/// the piece that is said to lie across. Empty: nothing.
std::string faultOfCut(const TriangleMesh& body, const FragmentSurfaces& cut);

}  // namespace sherd::fragment_support
