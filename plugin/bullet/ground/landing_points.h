#pragma once

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <LinearMath/btVector3.h>

#include <optional>
#include <vector>

#include "bullet/shapes/convex_part.h"

namespace sherd {

/// A whole body that lands on something.
struct LandingBody {
    const std::vector<btVector3>* outermost = nullptr;  ///< OwnedShape::outermost
    PlacedShape shape;                                  ///< where the body stood when the manifold was made
    btVector3 inside = btVector3(0, 0, 0);              ///< a point in the body, world frame
    btScalar spacing = 0;                               ///< of its particles, m
};

/// Where a body in truth touches the flat ground that it lands on, as contact points without impulse, the
/// deepest first: vertices of its surface. The hulls that stand for it in collisions have fewer: on the rim
/// of a plate they touch with both ends of an edge where the rim itself touches between them. `reach`:
/// vertices no further out than that, or than that above the deepest, count as well, m; of those closer
/// together than half a spacing the deepest. Where they are many, some of those that touch together, further
/// apart, and the deepest of the others. Nothing where the ground is not one plane under all of them.
/// `ground_stood`: where that was when the manifold was made.
std::optional<std::vector<btManifoldPoint>> landingPoints(const btPersistentManifold& manifold,
                                                          const LandingBody& body, bool body_is_a,
                                                          const btTransform& ground_stood, btScalar reach);

}  // namespace sherd
