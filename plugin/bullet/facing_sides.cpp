#include "bullet/facing_sides.h"

#include <BulletCollision/NarrowPhaseCollision/btPolyhedralContactClipping.h>

#include <algorithm>

namespace sherd {

namespace {

constexpr btScalar across = btScalar(0.98);  // cosine of an angle of 11 degrees

/// Corners of a clipped side between the margins, as contacts outside these.
class CornersAsContacts final : public btDiscreteCollisionDetectorInterface::Result {
  public:
    CornersAsContacts(btManifoldResult& result, const btVector3& normal, bool are_of_b, btScalar margin_a,
                      btScalar margin_b)
        : result_(result), normal_(normal), are_of_b_(are_of_b), margin_a_(margin_a), margin_b_(margin_b) {}
    void setShapeIdentifiersA(int, int) override {}
    void setShapeIdentifiersB(int, int) override {}
    void addContactPoint(const btVector3&, const btVector3& corner, btScalar height) override {
        const btVector3 on_b = are_of_b_ ? corner : corner - height * normal_;
        const btScalar distance = height - margin_a_ - margin_b_;
        deepest_ = std::min(deepest_, distance);
        result_.addContactPoint(normal_, on_b + margin_b_ * normal_, distance);
    }
    btScalar deepest() const { return deepest_; }

  private:
    btManifoldResult& result_;
    const btVector3& normal_;
    const bool are_of_b_;
    const btScalar margin_a_, margin_b_;
    btScalar deepest_ = BT_LARGE_FLOAT;
};

/// The largest cosine between a direction and the normal of a side.
btScalar mostAlong(const btVector3& direction, const PlacedSides& body) {
    const btVector3 own = direction * body.place.getBasis();
    btScalar most = -1;
    for (int i = 0; i < body.sides.m_faces.size(); ++i) {
        const btScalar* plane = body.sides.m_faces[i].m_plane;
        most = std::max(most, own.x() * plane[0] + own.y() * plane[1] + own.z() * plane[2]);
    }
    return most;
}

/// The corners are those of `other`.
void clip(const PlacedSides& base, const PlacedSides& other, const btVector3& normal, btScalar nearest,
          btScalar furthest, CornersAsContacts& corners) {
    btVertexArray clipped, scratch;
    btPolyhedralContactClipping::clipHullAgainstHull(normal, base.sides, other.sides, base.place, other.place,
                                                     nearest, furthest, clipped, scratch, corners);
}

}  // namespace

btScalar addContactsOfSides(const PlacedSides& a, const PlacedSides& b, const btVector3& normal,
                            btScalar nearest, btScalar furthest, btManifoldResult& result) {
    const btScalar along_a = mostAlong(-normal, a), along_b = mostAlong(normal, b);
    if (std::max(along_a, along_b) < across) return BT_LARGE_FLOAT;
    const btScalar margins = a.margin + b.margin;
    CornersAsContacts corners(result, normal, along_a >= along_b, a.margin, b.margin);
    if (along_a >= along_b)
        clip(a, b, normal, nearest + margins, furthest + margins, corners);
    else
        clip(b, a, -normal, nearest + margins, furthest + margins, corners);
    return corners.deepest();
}

}  // namespace sherd
