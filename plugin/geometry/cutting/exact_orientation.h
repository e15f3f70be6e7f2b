#pragma once

#include <sherd/types.h>

namespace sherd {

/// Exact sign (-1, 0, 1) of (b - a) x (c - a) . (d - a): 1 when d is on the side that the normal of a, b, c
/// points to.
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The same volume (six times that of the tetrahedron) in floating point, m^3.
inline double signedVolume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return (b - a).cross(c - a).dot(d - a);
}

}  // namespace sherd
