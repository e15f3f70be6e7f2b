#pragma once

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btConvexPolyhedron.h>

namespace sherd {

/// The sides of a convex shape, which collides at a margin outside them.
struct PlacedSides {
    const btConvexPolyhedron& sides;
    const btTransform& place;
    btScalar margin;  // m
};

/// Adds the contacts of two bodies that meet with a side: the corners of the side of one, clipped to the
/// outline of that of the other, and how far they are above it. `normal`: where the bodies are nearest, from
/// B to A. One of the sides has to lie across it, or the bodies meet with edges or corners and nothing is
/// added. No contact is deeper than `nearest` or further off than `furthest`, m. Returns the distance of the
/// deepest, m; BT_LARGE_FLOAT without any.
btScalar addContactsOfSides(const PlacedSides& a, const PlacedSides& b, const btVector3& normal,
                            btScalar nearest, btScalar furthest, btManifoldResult& result);

}  // namespace sherd
