#pragma once

#include <optional>

#include "core/loads/surface_tree.h"

namespace sherd {

/// A ball as it moves against a surface, frame of the surface.
struct MovingBall {
    Vec3 centre = Vec3::Zero();        ///< now, m
    Vec3 velocity_m_s = Vec3::Zero();  ///< not zero
    double radius_m = 0;               ///< above zero
};

/// Where a ball met a surface.
struct FirstTouch {
    Vec3 point = Vec3::Zero();  ///< m
    Vec3 push = Vec3::Zero();   ///< unit, from the ball's centre to it
    double ago_s = 0;
};

/// Where it touched a surface that faces it first, while it has come as it does, for `longest_ago_s`. None if
/// it touched before, not yet, or just grazes the surface.
std::optional<FirstTouch> firstTouch(const SurfaceTree& surface, const MovingBall& ball,
                                     double longest_ago_s);

/// Where it touched the surface in truth, if that is not as `known`, from what stands for the surface in
/// collisions. None where `known` is right, which another contact at the same time may be, too: then the ball
/// touches the surface there, on a face across the push or on an edge. Nor where there is no such touch, or
/// one that is much earlier or later.
std::optional<FirstTouch> trueTouch(const SurfaceTree& surface, const MovingBall& ball,
                                    const FirstTouch& known, double longest_ago_s);

}  // namespace sherd
