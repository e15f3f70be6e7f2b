#pragma once

#include <LinearMath/btVector3.h>

#include <array>
#include <functional>
#include <optional>

class btCollisionObject;
class btCollisionShape;
class btDiscreteDynamicsWorld;
class btManifoldPoint;
class btRigidBody;

namespace sherd {

/// A point of ground that is a surface without an inside: of a static triangle mesh or height field.
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

/// The nearest ground within `radius` of a point that pushes `body`, which is in the world.
std::optional<GroundPoint> groundNear(btDiscreteDynamicsWorld& world, const btRigidBody& body,
                                      const btVector3& from, btScalar radius);

}  // namespace sherd
