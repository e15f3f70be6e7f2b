#pragma once

#include <sherd/triangle_mesh.h>

#include <array>
#include <string>
#include <vector>

namespace sherd::fragment_support {

/// What CGAL finds wrong with a piece: not manifold, open, not connected to bound a volume, inward, a
/// triangle of no area, a doubled triangle, self-intersection. Empty: nothing.
std::string faultOf(const TriangleMesh& mesh);

using Corner = std::array<double, 3>;

/// A triangle by the coordinates of its corners, from the lowest on: the same for both sides of a crack but
/// for the turn.
std::array<Corner, 3> cornersOf(const TriangleMesh& mesh, std::size_t t, bool reversed);

/// What is wrong with the cracks between the pieces of one break: a triangle without exactly one partner in
/// another piece, turned the other way round and equal bit for bit. Empty: nothing.
std::string faultOfCracks(const std::vector<TriangleMesh>& pieces);

}  // namespace sherd::fragment_support
