#pragma once

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>

namespace sherd {

/// A hull of a fragment: PieceContacts finds what it touches.
class PieceHull final : public btConvexHullShape {
  public:
    /// Without run-time type information, which the shapes of an app may lack.
    static bool is(const btCollisionShape& shape) {
        return shape.getShapeType() == CONVEX_HULL_SHAPE_PROXYTYPE && shape.getName() == name;
    }
    const char* getName() const override { return name; }

  private:
    static constexpr char name[] = "PieceHull";
};

}  // namespace sherd
