#pragma once

#include "core/mlpg/rigid_motions.h"

namespace sherd {

/// Balances the loads of a free body by rigid acceleration, b(x) = -rho (a + alpha x r), each connected
/// component by itself. Each trial space integrates the body forces with the quadrature that builds its K, so
/// that net force and moment vanish to rounding.
class InertiaRelief {
  public:
    using Mat6 = Eigen::Matrix<double, 6, 6>;
    using Forces = Eigen::Matrix<double, Eigen::Dynamic, 6>;

    /// `forces`, #unknowns x 6: of unit density times each rigid motion. `masses`, per component: their
    /// resultants.
    InertiaRelief(Forces forces, std::vector<Mat6> masses);
    /// The same, with the resultants that the motions give.
    InertiaRelief(Forces forces, const RigidMotions& motions);

    /// Resultants of the six forces of a component, 6 x 6: its mass matrix at unit density.
    const Mat6& mass(int component) const { return masses_[static_cast<size_t>(component)]; }
    const Forces& forces() const { return forces_; }
    /// The six forces on an unknown.
    Forces::ConstRowXpr forceOn(long unknown) const { return forces_.row(unknown); }

    /// Factors of the six motions whose inertia balances `resultants`, 6 x #components.
    Eigen::Matrix<double, 6, Eigen::Dynamic> accelerationOf(
        const Eigen::Matrix<double, 6, Eigen::Dynamic>& resultants) const;
    /// Adds to `forces`, whose resultants are `resultants` (6 x #components, as RigidMotions), what balances
    /// them. Returns accelerationOf(resultants).
    Eigen::Matrix<double, 6, Eigen::Dynamic> balance(
        Eigen::VectorXd& forces, const Eigen::Matrix<double, 6, Eigen::Dynamic>& resultants,
        const RigidMotions& motions) const;

  private:
    Forces forces_;
    std::vector<Mat6> masses_;
};

}  // namespace sherd
