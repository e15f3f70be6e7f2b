#pragma once

#include <sherd/triangle_mesh.h>

#include <vector>

#include "geometry/cutting/crack_complex.h"

namespace sherd {

/// Triangles of a body and of the cracks that may cross.
struct NearPair {
    int body_triangle, crack_triangle;
};

/// The pairs whose bounding boxes meet, by body triangle, then by crack triangle. The lattice, whose
/// cracks these are, knows the body's triangles in each of its cells.
std::vector<NearPair> findNearPairs(const TriangleMesh& body, const LabelLattice& lattice,
                                    const CrackComplex& crack);

}  // namespace sherd
