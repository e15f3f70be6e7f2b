#pragma once

#include <Eigen/Dense>
#include <vector>

#include "core/mlpg/particle_forms/shape_functions.h"
#include "core/mlpg/splines/spline_space.h"

namespace sherd {

/// The six rigid motions of every connected component: three translations, and three rotations about the
/// component's centre of mass divided by its size, so that all six move points by about as much.
struct RigidMotions {
    Components components;
    std::vector<Moments> moments;  ///< per component
    std::vector<double> size;      ///< per component: the length that rotations are divided by, m
    Eigen::Matrix<double, Eigen::Dynamic, 6>
        coefficients;  ///< #unknowns x 6: the unknowns of each motion of the component
    int unknowns_per_particle = 0;

    RigidMotions(const Discretisation& solid, const TrialSpace& space);
    RigidMotions(const CellParts& solid, const SplineSpace& space);

    int componentOfUnknown(long unknown) const {
        return components.of_particle[static_cast<size_t>(unknown / unknowns_per_particle)];
    }

    /// Velocities at x of the six motions of a component, 3 x 6.
    Eigen::Matrix<double, 3, 6> at(const Vec3& x, int component) const;

    /// Work of generalised forces on each motion, 6 x #components: net force, and net moment over size.
    Eigen::Matrix<double, 6, Eigen::Dynamic> resultants(const Eigen::VectorXd& forces) const;
};

/// For each component up to six unknowns far apart; holding them at zero leaves no rigid motion (pivoted
/// Gram-Schmidt on the rows of `coefficients`). Fewer than six where the unknowns cannot express all six
/// motions.
std::vector<int> unknownsToPin(const RigidMotions& motions);

}  // namespace sherd
