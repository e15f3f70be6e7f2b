#pragma once

#include <vector>

#include "geometry/cutting/fragment_surfaces.h"

namespace sherd {

/// Vertices at the same position, in whatever pieces, under one number.
struct SharedVertices {
    std::vector<std::vector<int>> of_piece;  ///< #pieces, #V each
    int count = 0;
};
SharedVertices shareVertices(const std::vector<FragmentSurface>& pieces);

const Vec3 unknown_colour = Vec3::Constant(-1);

/// Fills the unknown colours ring by ring along the edges of crack faces: each is the mean of those of its
/// neighbours that were known before; what cannot be reached gets `otherwise`.
void spreadColours(const std::vector<FragmentSurface>& pieces, const SharedVertices& shared,
                   const Vec3& otherwise, std::vector<Vec3>& colours);

}  // namespace sherd
