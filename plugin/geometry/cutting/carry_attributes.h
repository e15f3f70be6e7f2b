#pragma once

#include <vector>

#include "geometry/cutting/fragment_surfaces.h"

namespace sherd {

/// Gives the pieces of a body its attributes; does nothing for a body without any.
/// A corner that is a corner of its parent triangle keeps that one's values bit for bit; other corners on the
/// body have them interpolated there (normals are made unit again). Crack faces get the material `crack` (the
/// rest is `original` where the body has texture coordinates but no materials), their own normals, and their
/// position along two axes of the body's frame as texture coordinates, m: one pair of axes for all that two
/// pieces share, unless a triangle would be seen too obliquely. Colours spread into the cracks from their
/// rims, each vertex the mean of its neighbours that are nearer to a rim; cracks without a rim take the mean
/// colour of the body.
void carryAttributes(const TriangleMesh& body, std::vector<FragmentSurface>& pieces);

}  // namespace sherd
