#pragma once

#include <vector>

#include "geometry/cutting/fragment_surfaces.h"

namespace sherd {

/// Gives the pieces of a body its attributes; does nothing for a body without any.
/// On the body's surface a corner that is also one of its parent triangle keeps that one's values bit for
/// bit; at all others they are interpolated, and normals scaled back to unit length. Crack faces get their
/// own normals, the material `crack` (the rest is `original` where the body has texture coordinates but no
/// materials), and as texture coordinates two coordinates of their position in the body's frame, m: the same
/// two for all faces between two pieces, but for triangles that would be seen too obliquely. Colours spread
/// from the rims of cracks inward: each vertex takes the mean of its neighbours nearer to a rim. Cracks
/// without a rim take the mean colour of the body.
void carryAttributes(const TriangleMesh& body, std::vector<FragmentSurface>& pieces);

}  // namespace sherd
