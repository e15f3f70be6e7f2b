#pragma once

#include <sherd/types.h>

#include "core/sampling/discretisation.h"

namespace sherd {

/// Force and moment about a body's centre of mass, or translation and turn of it.
using Wrench = Eigen::Matrix<double, 6, 1>;

/// How a free rigid body gives way to impulses, asset frame. All zero: it does not.
struct Mobility {
    Vec3 centre = Vec3::Zero();           ///< of mass, m
    double inverse_mass = 0;              ///< 1/kg
    Mat3 inverse_inertia = Mat3::Zero();  ///< about the centre, 1/(kg m^2)

    /// Of a solid of even density.
    static Mobility of(const Moments& moments, double density_kg_m3);
    /// Of a mass that does not turn.
    static Mobility ofPoint(double mass_kg, const Vec3& position = Vec3::Zero());

    /// The same where turns are held back: `free_turns` is the share of a turn about each axis that is left,
    /// symmetric, asset frame.
    Mobility heldBack(const Mat3& free_turns) const;

    bool fixed() const { return inverse_mass == 0; }
    double mass() const { return 1 / inverse_mass; }
    /// Force and moment of a force at a point.
    Wrench wrench(const Vec3& point, const Vec3& force) const;
    /// Change of velocity and spin over impulse and angular impulse.
    Wrench response(const Wrench& impulse) const;
    /// Change of velocity over impulse at one point, 3 x 3, 1/kg.
    Mat3 at(const Vec3& point) const;
    /// 6 x 6 symmetric R with R R w = response(w).
    Eigen::Matrix<double, 6, 6> root() const;
};

}  // namespace sherd
