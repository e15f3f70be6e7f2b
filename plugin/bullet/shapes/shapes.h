#pragma once

#include <LinearMath/btVector3.h>
#include <sherd/result.h>
#include <sherd/types.h>

#include <vector>

class btCollisionObject;
class btCollisionShape;
class btConvexShape;

namespace sherd {

/// Points whose convex hull is the shape (exactly for polyhedra, approximately for round shapes), in the
/// shape's frame, m.
std::vector<Vec3> supportPoints(const btConvexShape& shape);

/// Convex solids, each as the points of its hull, m.
using ConvexParts = std::vector<std::vector<Vec3>>;

/// The convex parts of a convex shape or of a compound of such, to any depth, in the frame of `shape`. The
/// error names the child that is not convex.
Result<ConvexParts> convexParts(const btCollisionShape& shape);

/// Whether a shape has a scaling: those that Sherd makes have none.
bool isScaled(const btCollisionShape& shape);

/// Of the box about an object along its own axes, m.
btVector3 extentOf(const btCollisionObject& object);

/// Radius of curvature, m, of spheres, capsules, cylinders and the like; 0 for other shapes, whose surface is
/// flat or unknown. `child` is the index of the child shape in Bullet's contact point, -1 if it has none.
double strikingRadius(const btCollisionShape& shape, int child);

/// The same of balls and capsules alone, which touch at that distance from their middle.
double ballRadius(const btCollisionShape& shape, int child);

}  // namespace sherd
