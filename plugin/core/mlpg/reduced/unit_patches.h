#pragma once

#include <sherd/types.h>

#include <vector>

#include "core/sampling/discretisation.h"

namespace sherd {

/// A part of a solid's surface under 1 N, spread over the sampling's own surface points.
struct UnitPatch {
    struct Point {
        Vec3 position = Vec3::Zero();  ///< m
        double weight = 0;             ///< all of a patch have 1 in sum
    };
    std::vector<Point> points;
    Vec3 middle = Vec3::Zero();  ///< the point that the patch was made about, m
    Vec3 inward = Vec3::Zero();  ///< unit normal there
    bool on_edge = false;        ///< faces meet there at an angle
};

/// Up to `count` patches that cover the surface evenly: each next one is made about the point that is
/// farthest from all before. Without a radius they have about the area of the surface together.
std::vector<UnitPatch> unitPatches(const Discretisation& solid, int count, double radius_m = 0);

/// Up to `count` patches about corners of the surface's triangles where faces meet at an angle.
std::vector<UnitPatch> edgePatches(const Discretisation& solid, int count, double radius_m);

/// Radius of each of so many circles that have the area of the surface together, m.
double evenRadius(const Discretisation& solid, int count);

}  // namespace sherd
