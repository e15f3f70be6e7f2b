#pragma once

#include <LinearMath/btVector3.h>

#include <optional>

class btCollisionObject;
class btDiscreteDynamicsWorld;
class btRigidBody;

namespace sherd {

/// A point of ground that is a surface without an inside: of a static triangle mesh or height field.
struct GroundPoint {
    const btCollisionObject* ground = nullptr;
    btVector3 point = btVector3(0, 0, 0);   ///< world frame
    btVector3 normal = btVector3(0, 0, 0);  ///< unit, to the side from which the ground was looked at
    btScalar distance = 0;                  ///< from there, m
};

bool isGroundSurface(const btCollisionObject& object);
/// Whether there is any in the world.
bool hasGroundSurface(const btDiscreteDynamicsWorld& world);

/// The first ground on the straight way between two points that pushes `body`, which is in the world.
std::optional<GroundPoint> groundBetween(btDiscreteDynamicsWorld& world, const btRigidBody& body,
                                         const btVector3& from, const btVector3& to);

/// The nearest ground within `radius` of a point that pushes `body`, which is in the world.
std::optional<GroundPoint> groundNear(btDiscreteDynamicsWorld& world, const btRigidBody& body,
                                      const btVector3& from, btScalar radius);

}  // namespace sherd
