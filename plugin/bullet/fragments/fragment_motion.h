#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <sherd/push.h>

#include <vector>

namespace sherd {

/// Gives the pieces, which are placed already, the common rigid motion that has the linear and angular
/// momentum of the whole. For a body made from an asset this is the whole's own velocity at each centre. An
/// app's body may have an inertia or a centre of mass that differs from its shape's; then momentum is
/// conserved rather than spin, where that adds no energy.
void shareMotion(const btRigidBody& whole, const std::vector<btRigidBody*>& pieces);

/// Gives the pieces the whole's own motion, each at its place: of a body some of whose pieces the world
/// holds.
void followMotion(const btRigidBody& whole, const std::vector<btRigidBody*>& pieces);

/// Pushes the pieces as if they were one rigid body, with as much of all pushes as moves the point of none of
/// them by more than its speed.
void pushAsOne(const std::vector<btRigidBody*>& pieces, const std::vector<Push>& pushes);

/// Distributes the forces and torques that the solve will apply (gravity and the app's own), such that all
/// pieces accelerate as parts of the rigid whole. `gravity_if_none`: inside a step, where a body without any
/// force is one that slept, and got no gravity.
void shareForces(const btRigidBody& whole, const std::vector<btRigidBody*>& pieces, bool gravity_if_none);

/// Difference of linear and angular momentum (about the centre of the whole) between the whole and the
/// pieces, relative to the sum of the magnitudes of the pieces' own; the larger of the two.
double momentumDifference(const btRigidBody& whole, const std::vector<const btRigidBody*>& pieces);

}  // namespace sherd
