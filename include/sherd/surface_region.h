#pragma once

#include <sherd/types.h>

#include <string>
#include <variant>

namespace sherd {

// Regions are in the asset frame. A sphere and a box cut triangles at their own boundary; a cylinder takes
// whole ones. A sphere or a box that reaches through a wall takes both of its faces.

/// The surface inside a ball.
struct SphereRegion {
    Vec3 centre = Vec3::Zero();  ///< m
    double radius_m = 0;
};

/// The surface inside a box whose edges are parallel to the axes. A flat box takes the face that lies in it.
struct BoxRegion {
    Vec3 lo = Vec3::Zero();  ///< the corner of least x, y and z, m
    Vec3 hi = Vec3::Zero();  ///< the opposite corner, m
};

/// The triangles that lie on an endless cylinder: a bore or a shaft.
struct CylinderRegion {
    Vec3 point = Vec3::Zero();  ///< any point of the axis, m
    Vec3 axis = Vec3::UnitZ();  ///< of any length
    double radius_m = 0;
};

inline bool operator==(const SphereRegion& a, const SphereRegion& b) {
    return a.centre == b.centre && a.radius_m == b.radius_m;
}
inline bool operator==(const BoxRegion& a, const BoxRegion& b) {
    return a.lo == b.lo && a.hi == b.hi;
}
inline bool operator==(const CylinderRegion& a, const CylinderRegion& b) {
    return a.point == b.point && a.axis == b.axis && a.radius_m == b.radius_m;
}

/// A part of a body's surface.
using SurfaceRegion = std::variant<SphereRegion, BoxRegion, CylinderRegion>;

/// What a region is, for sentences: "the sphere about (0, 0, 0.5) m of radius 0.08 m".
std::string describe(const SurfaceRegion& region);

/// A traction on a part of the surface: that of a force plus that of a pressure.
struct SurfaceLoad {
    SurfaceRegion region;
    Vec3 force_n = Vec3::Zero();  ///< total, spread over the region's area as one traction vector
    double pressure_pa = 0;       ///< pushes along the inward normal
};

}  // namespace sherd
