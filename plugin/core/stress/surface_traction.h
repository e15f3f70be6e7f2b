#pragma once

#include <sherd/stress_field.h>

#include "core/sampling/discretisation.h"
#include "core/stress/elasticity.h"

namespace sherd {

/// The stress at a point of the surface where traction t acts: strains within the surface are taken from
/// `raw`, as the displacements give them, and the rest follows from sigma n = t. With P = I - n n^T
///     sigma = P raw P + nu / (1 - nu) (t_n - raw_nn) P + t_t n^T + n t_t^T + t_n n n^T.
/// Displacements converge an order faster than the stress that balances t only in the weak sense.
SymmetricTensor withTraction(const SymmetricTensor& raw, const Vec3& normal, const Vec3& traction_pa,
                             const Elasticity& elasticity);

/// Clears the traction at every surface point with a normal that is further than a particle spacing from
/// where something acts on the body.
void freeSurface(const Discretisation& solid, const std::vector<PointForce>& acting,
                 const Elasticity& elasticity, std::vector<SymmetricTensor>& surface);

}  // namespace sherd
