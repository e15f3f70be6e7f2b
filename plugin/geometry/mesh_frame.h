#pragma once

#include <sherd/triangle_mesh.h>

namespace sherd {

/// An error unless the scale is above 0 and finite.
Status checkScale(double scale);

/// The mesh with its coordinates multiplied with `scale`, turned so that `up_axis` becomes z.
TriangleMesh placed(TriangleMesh mesh, double scale, UpAxis up_axis);

}  // namespace sherd
