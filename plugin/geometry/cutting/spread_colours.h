#pragma once

#include <vector>

#include "geometry/cutting/fragment_surfaces.h"

namespace sherd {

/// Numbers for the vertices of all pieces; those at the same position have the same.
struct SharedVertices {
    std::vector<std::vector<int>> of_piece;  ///< #pieces, #V each
    int count = 0;
};
SharedVertices shareVertices(const std::vector<FragmentSurface>& pieces);

const Vec3 unknown_colour = Vec3::Constant(-1);

/// Fills the unknown colours ring by ring along the edges of crack faces: each vertex takes the mean of its
/// neighbours that had a colour before its ring. Vertices that no ring reaches get `otherwise`.
void spreadColours(const std::vector<FragmentSurface>& pieces, const SharedVertices& shared,
                   const Vec3& otherwise, std::vector<Vec3>& colours);

}  // namespace sherd
