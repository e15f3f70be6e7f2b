#pragma once

#include <optional>

#include "core/loads/surface_tree.h"

namespace sherd {

/// Where a ball met a surface, frame of the surface.
struct FirstTouch {
    Vec3 point = Vec3::Zero();  ///< m
    Vec3 push = Vec3::Zero();   ///< unit, from the ball's centre to it
    double ago_s = 0;
};

/// A ball that is at `centre` now and comes with `velocity_m_s`, as it did for `longest_ago_s`.
/// `guess_ago_s`: by what stands for the surface in collisions. None if it touched what faces it before, or
/// more than half its radius later than that guess, or just grazes it.
std::optional<FirstTouch> firstTouch(const SurfaceTree& surface, const Vec3& centre, const Vec3& velocity_m_s,
                                     double radius_m, double guess_ago_s, double longest_ago_s);

}  // namespace sherd
