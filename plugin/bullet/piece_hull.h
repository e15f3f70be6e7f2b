#pragma once

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>

namespace sherd {

/// A hull of a fragment: PieceContacts finds what it touches.
class PieceHull final : public btConvexHullShape {
  public:
    /// nullptr of other shapes. Without run-time type information, which the shapes of an app may lack.
    static const PieceHull* of(const btCollisionShape& shape) {
        const bool is_hull = shape.getShapeType() == CONVEX_HULL_SHAPE_PROXYTYPE;
        return is_hull && shape.getName() == name ? static_cast<const PieceHull*>(&shape) : nullptr;
    }
    const char* getName() const override { return name; }

  private:
    static constexpr char name[] = "PieceHull";
};

}  // namespace sherd
