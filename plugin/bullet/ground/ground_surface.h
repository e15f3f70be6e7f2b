#pragma once

#include <LinearMath/btVector3.h>

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "bullet/ground/moved_ground.h"

class btCollisionObject;
class btCollisionShape;
class btDiscreteDynamicsWorld;
class btManifoldPoint;
class btRigidBody;

namespace sherd {

/// A point of ground that is a surface without an inside: of a triangle mesh or height field, static or
/// kinematic.
struct GroundPoint {
    const btCollisionObject* ground = nullptr;
    btVector3 point = btVector3(0, 0, 0);   ///< world frame
    btVector3 normal = btVector3(0, 0, 0);  ///< unit, to the side from which the ground was looked at
    btScalar distance = 0;                  ///< from there, m
};

/// Whether a shape has triangles, as a mesh or a height field, or a part that has.
bool hasSurface(const btCollisionShape& shape);
bool isGroundSurface(const btCollisionObject& object);
/// Whether a contact is with a triangle of the second body, or the first, and not with another part of it.
bool isOnTriangle(const btManifoldPoint& point, bool of_second);
/// Whether there is any in the world.
bool hasGroundSurface(const btDiscreteDynamicsWorld& world);

/// Calls visit(corners) for the triangles of such ground that may reach into a box; all in the world frame.
void forEachTriangle(const btCollisionObject& ground, const btVector3& low, const btVector3& high,
                     const std::function<void(const std::array<btVector3, 3>&)>& visit);

/// Of a triangle the point that is nearest to another.
btVector3 nearestOf(const std::array<btVector3, 3>& corners, const btVector3& to);

/// The first ground on the straight way between two points that pushes `body`, which is in the world.
std::optional<GroundPoint> groundBetween(btDiscreteDynamicsWorld& world, const btRigidBody& body,
                                         const btVector3& from, const btVector3& to);

/// The same for the way in a step, whose ground may have moved before it: what a point on such ground would
/// have come from is where that took it to.
std::optional<GroundPoint> groundCrossed(btDiscreteDynamicsWorld& world, const btRigidBody& body,
                                         const btVector3& from, const btVector3& to,
                                         const MovedSurfaces& moved);

/// How the ground of a point that is found has moved; not at all if it is none of `moved`.
btTransform moveOf(const std::optional<GroundPoint>& point, const MovedSurfaces& moved);

/// A point of a body; what has moved across it since the last step is taken back from it.
btVector3 onItsSide(btDiscreteDynamicsWorld& world, const btRigidBody& body, const btVector3& point,
                    const MovedSurfaces& moved);

/// The nearest ground within `radius` of a point that pushes `body`, which is in the world.
std::optional<GroundPoint> groundNear(btDiscreteDynamicsWorld& world, const btRigidBody& body,
                                      const btVector3& from, btScalar radius);

}  // namespace sherd
