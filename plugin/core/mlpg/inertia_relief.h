#pragma once

#include "core/mlpg/particle_forms/cell_gradients.h"
#include "core/mlpg/rigid_motions.h"

namespace sherd {

/// Balances the loads of a free body by rigid acceleration, b(x) = -rho (a + alpha x r), each connected
/// component by itself. The body forces are integrated with the quadrature that builds K, cell by cell with
/// its second moment, so that net force and moment vanish to rounding.
class InertiaRelief {
  public:
    /// Galerkin: f_a = sum over sub-domains P of phi_a(x_P) int_P b + sum_c g_ca . int_c b (x - x_P)^T.
    static InertiaRelief galerkin(const Discretisation& solid, const SupportGraph& supports,
                                  const TrialSpace& space, const CellGradients& cells,
                                  const RigidMotions& motions);

    /// Heaviside: the rows of sub-domain P get int_P b.
    static InertiaRelief heaviside(const Discretisation& solid, const RigidMotions& motions);

    /// Splines: exact, from int phi_a (1, x - c) dV of every function, c the component's centre of mass
    /// (4 x #functions, see splineBodyMoments).
    static InertiaRelief splines(const Eigen::Matrix4Xd& body_moments, const RigidMotions& motions);

    /// Resultants of the six forces of a component, 6 x 6: its mass matrix at unit density.
    const Eigen::Matrix<double, 6, 6>& mass(int component) const {
        return masses_[static_cast<size_t>(component)];
    }

    /// Adds to `forces`, whose resultants are `resultants` (6 x #components, as RigidMotions), what balances
    /// them.
    /// Returns the factors of the six motions, 6 x #components.
    Eigen::Matrix<double, 6, Eigen::Dynamic> balance(
        Eigen::VectorXd& forces, const Eigen::Matrix<double, 6, Eigen::Dynamic>& resultants,
        const RigidMotions& motions) const;

  private:
    void sumResultants(const RigidMotions& motions);

    using Mat6 = Eigen::Matrix<double, 6, 6>;
    Eigen::Matrix<double, Eigen::Dynamic, 6>
        forces_;                // #unknowns x 6: of unit density times each rigid motion
    std::vector<Mat6> masses_;  // per component: their resultants
};

}  // namespace sherd
