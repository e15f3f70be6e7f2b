#pragma once

#include <Eigen/Dense>

namespace sherd {

/// The free vibrations of a body under loads of 1 N in total. Modes are scaled so that one of amplitude a has
/// the strain energy a^2 / 2. Under a force F(t) with those loads each is an oscillator,
///     a'' = w^2 (work F - a).
struct StruckModes {
    Eigen::ArrayXd rates_rad_s;  ///< w, ascending, and then those of the loads
    Eigen::ArrayXd work;         ///< of the loads on each mode of amplitude 1, J^(1/2) / N
    /// The stress of the slowest modes over their amplitude at places where it may be largest, Pa / J^(1/2),
    /// #places x #slowest; none if no such places are known.
    Eigen::MatrixXd hot_pa = {};
    /// The displacement of the last modes over their amplitude, if these are of the loads and not of the body
    /// (addRitzVectors), m / J^(1/2), #unknowns x #such modes. Each stands for many modes that get out of
    /// step, which damps it:
    ///     a'' = w^2 (work F - a) - 2 ritz_damping w a'.
    Eigen::MatrixXf ritz_vectors = {};
    static constexpr double ritz_damping = 0.1;

    bool empty() const { return rates_rad_s.size() == 0; }
    double slowestPeriod() const;  ///< s; 0 if there are none
    /// Strain energy that the modes have under the static loads, J.
    double staticEnergy() const { return 0.5 * work.square().sum(); }
};

}  // namespace sherd
