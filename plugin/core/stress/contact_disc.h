#pragma once

#include <sherd/types.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/stress/stress_lanes.h"

namespace sherd {

/// How strong the traction of a contact is at `squared` = (r / radius)^2, relative to its middle:
/// (1 - (r / radius)^2)^(3/2). Hertz's own, with the exponent 1/2, has a cusp of tension at its rim, which
/// acts on next to no material and which neither a grid nor a finite-element mesh resolves (elements of 1/40
/// of the radius find 10 % less). With 3/2 the largest stress is about the same and can be found.
inline double contactProfile(double squared) {
    const double left = std::max(0.0, 1 - squared);
    return left * std::sqrt(left);
}

/// A traction of a contact on a disc of a plane. Its part along the plane is that of a contact that slides.
struct ContactDisc {
    Vec3 centre = Vec3::Zero();       ///< m
    Vec3 inward = Vec3::Zero();       ///< unit normal of the plane, into the solid
    double radius = 0;                ///< m
    Vec3 traction_pa = Vec3::Zero();  ///< in the middle
    bool hollow = false;              ///< whether the surface about it rises above the plane

    /// The traction at a point of the plane, Pa.
    Vec3 tractionAt(const Vec3& x) const;
};

/// The stress that a disc's traction makes in a half-space, in closed form: for this profile what G. M.
/// Hamilton and L. E. Goodman, The stress field created by a circular sliding contact, J. Appl. Mech. 33
/// (1966), found for Hertz's.
class DiscField {
  public:
    DiscField(const ContactDisc& disc, double poisson_ratio);

    /// At x, Pa. Before the plane as on it; under a hollow surface, which lies there, as it changes behind
    /// the plane; zero far before it.
    Mat3 stressAt(const Vec3& x) const;
    /// Adds the same, but for the last digits, at several places.
    void addStressAt(const PlaceLanes& at, StressLanes& sum) const;

    /// What the field depends on.
    struct Traction {
        double nu;
        double along_pa, inward_pa;  ///< its parts
    };
    /// Of each component of the stress in the world, what it has of those on the disc's axes.
    using Turning = std::array<std::array<double, 6>, 6>;

  private:
    /// In radii and on the disc's own axes, z >= 0.
    Mat3 behind(double x, double y, double z) const;
    Mat3 turned(const Mat3& local) const;

    Vec3 centre_;
    Mat3 axes_;           ///< rows: along the tangential traction, across it, inward
    Mat3 axes_in_radii_;  ///< the same over the radius
    Turning turning_;
    bool hollow_;
    Traction traction_;
};

}  // namespace sherd
