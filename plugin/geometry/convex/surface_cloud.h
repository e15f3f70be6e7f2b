#pragma once

#include <sherd/triangle_mesh.h>

#include <array>
#include <limits>
#include <memory>
#include <vector>

#include "geometry/convex/cut_tree.h"

namespace sherd {

/// Points that stand for the part of a closed surface in a box: cheap to measure and to cut.
struct SurfaceCloud {
    /// Flat faces of the surface that lie across an axis.
    struct Step {
        double offset = 0;  ///< m
        double area = 0;    ///< m^2
    };

    std::vector<Vec3> points;  ///< just inside the surface, or on planes that cut it; m
    /// The area vector that each stands for, m^2; zero where planes cut the surface.
    std::vector<Vec3> areas;
    double spacing = 0;  ///< about that between points, or more, m
    /// Of the whole surface, for each axis, in their order.
    std::shared_ptr<const std::array<std::vector<Step>, 3>> steps;
    /// The offsets of the planes that the surface was cut by, below and above along each axis; infinite where
    /// it was not.
    Vec3 cut_below = Vec3::Constant(-std::numeric_limits<double>::infinity());
    Vec3 cut_above = Vec3::Constant(std::numeric_limits<double>::infinity());
};

/// At most some thousand points; large triangles get more than their corners.
SurfaceCloud cloudOf(const TriangleMesh& surface);

/// The parts below and above a plane, each with points on the plane where the surface crosses it.
std::array<SurfaceCloud, 2> parted(const SurfaceCloud& cloud, const AxisPlane& plane);

/// About the volume of the solid in the box, m^3; negative if that is not known, in a box that planes bound
/// on all sides.
double solidVolume(const SurfaceCloud& cloud);

/// Whether a point is in the solid, and no point of the cloud of the whole surface within half a spacing; by
/// the winding number (Barill et al. 2018, in first order), which is only about right nearer than that.
bool isWellInside(const Vec3& x, const SurfaceCloud& whole);

}  // namespace sherd
