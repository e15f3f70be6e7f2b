#pragma once

#include "core/mlpg/inertia_relief.h"
#include "core/mlpg/splines/spline_loads.h"

namespace sherd {

/// int phi_a (1, x - c) dV of every function that carries unknowns, c the centre of mass of its component;
/// 4 x #functions, m^3 and m^4.
Eigen::Matrix4Xd inertiaMoments(const CellParts& solid, const SplineSpace& space,
                                const RigidMotions& motions);

/// Exact, from inertiaMoments.
InertiaRelief splineInertia(const Eigen::Matrix4Xd& moments, const RigidMotions& motions);

/// The inertia force of a steady rotation about the centre of mass, -rho w x (w x r), as a matrix times r.
Mat3 spinForce(const Vec3& spin_rad_s, double density_kg_m3);

/// Adds it to the forces at the unknowns. Returns the sum of the magnitudes added, N.
double addSpin(const Mat3& spin_force, const Eigen::Matrix4Xd& moments, Eigen::VectorXd& forces);

/// Per part, the forces of the rigid acceleration that balances the loads (6 x #components, as
/// InertiaRelief::balance returns it) and of a spin.
std::vector<AffineForce> inertiaForces(const SplineSpace& space, const RigidMotions& motions,
                                       const Eigen::Matrix<double, 6, Eigen::Dynamic>& acceleration,
                                       const Mat3& spin_force);

}  // namespace sherd
