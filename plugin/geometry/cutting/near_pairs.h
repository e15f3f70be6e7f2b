#pragma once

#include <vector>

#include "geometry/cutting/crack_complex.h"
#include "geometry/cutting/cuttable_surface.h"

namespace sherd {

/// Triangles of a body and of the cracks that may cross.
struct NearPair {
    int body_triangle, crack_triangle;
};

/// The pairs whose bounding boxes meet, by body triangle, then by crack triangle. The cells of the lattice,
/// whose cracks these are, serve as the grid.
std::vector<NearPair> findNearPairs(const CuttableSurface& body, const LabelLattice& lattice,
                                    const CrackComplex& crack);

}  // namespace sherd
