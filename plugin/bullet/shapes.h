#pragma once

#include <sherd/result.h>
#include <sherd/types.h>

#include <vector>

class btCollisionObject;
class btCollisionShape;
class btConvexShape;

namespace sherd {

/// Points whose convex hull is the shape (exactly for polyhedra) or stands for it (round shapes). Shape's
/// frame, m.
std::vector<Vec3> supportPoints(const btConvexShape& shape);

/// The convex parts of a convex shape or of a compound of such, to any depth, each as the points of its hull
/// in the frame of `shape`. The error names the child that is not convex.
Result<std::vector<std::vector<Vec3>>> convexParts(const btCollisionShape& shape);

/// Radius of curvature of a striking shape: of spheres, capsules, cylinders and their like, m; 0 for all
/// others, whose surface is flat or not known. `child` is the index that Bullet's contact point carries, -1
/// when it has none.
double strikingRadius(const btCollisionShape& shape, int child);

}  // namespace sherd
