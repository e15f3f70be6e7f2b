#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <vector>

namespace sherd {

/// Gives pieces, placed already, the rigid motion that has the linear and angular momentum of the whole. For
/// a body made from an asset that is the whole's own velocity at each centre; a body of the app's may have
/// been given an inertia or a centre that its shape has not, and then momentum is kept rather than spin.
void shareMotion(const btRigidBody& whole, const std::vector<btRigidBody*>& pieces);

/// Splits the forces and the torque that wait for the solver (gravity, and what the app applied) as the
/// acceleration of the rigid whole.
void shareForces(const btRigidBody& whole, const std::vector<btRigidBody*>& pieces);

/// Difference of linear and angular momentum (about the centre of the whole) between the whole and the
/// pieces, relative to the sum of the magnitudes of the pieces' own; the larger of the two.
double momentumDifference(const btRigidBody& whole, const std::vector<const btRigidBody*>& pieces);

}  // namespace sherd
