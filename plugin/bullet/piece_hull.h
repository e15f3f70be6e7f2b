#pragma once

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btConvexPolyhedron.h>

namespace sherd {

/// A hull of a fragment: PieceContacts finds what it touches. Its sides are not Bullet's polyhedral features:
/// with these, other algorithms of Bullet's leave the margins out.
class PieceHull final : public btConvexHullShape {
  public:
    /// Faces with vertices and planes. What only Bullet's test of all separating axes reads, the edges and an
    /// inner box, is not needed.
    btConvexPolyhedron sides;
};

}  // namespace sherd
