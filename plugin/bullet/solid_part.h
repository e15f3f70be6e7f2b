#pragma once

#include <sherd/triangle_mesh.h>

#include <array>
#include <vector>

namespace sherd {

/// A plane across an axis.
struct AxisPlane {
    int axis = 0;
    double offset = 0;                                               ///< m
    double height(const Vec3& x) const { return x[axis] - offset; }  ///< m, of a point above it
};

/// A part of a solid that planes cut off.
struct SolidPart {
    std::vector<Vec3> points;  ///< of the surface, and where planes cut it; their hull is that of the part, m
    std::vector<std::array<int, 3>> triangles;  ///< of the surface
    /// Close the surface where it was cut, but for the volume only: fans about a point of the plane, whose
    /// signed areas add up to the section.
    std::vector<std::array<Vec3, 3>> caps;
};

/// The solid that a closed surface bounds, with all vertices in the same cell of a cubic grid made one. The
/// surface stays closed, so its volume can still be summed.
SolidPart simplifiedSolid(const TriangleMesh& surface, double cell_m);

double volumeOf(const SolidPart& part);  ///< m^3

/// What lies above a plane, or below.
SolidPart cutOff(const SolidPart& whole, const AxisPlane& plane, bool above);

}  // namespace sherd
