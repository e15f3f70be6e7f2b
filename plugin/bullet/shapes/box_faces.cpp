#include "bullet/shapes/box_faces.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>

#include <cmath>
#include <optional>

#include "bullet/shapes/convex_part.h"

namespace sherd {

namespace {

constexpr btScalar exact = btScalar(1e-6);   // of the cosine
constexpr btScalar of_face = btScalar(0.7);  // cosine of the angle from which on a normal is no face's

bool isBox(const ConvexPart& part) {
    return part.shape && part.shape->getShapeType() == BOX_SHAPE_PROXYTYPE;
}

/// The vertex that is lowest along an axis of a frame, in that frame; nothing of a part without vertices.
std::optional<btVector3> lowest(const ConvexPart& part, const btTransform& frame, int axis, btScalar side) {
    const btTransform to_frame = frame.inverseTimes(part.transform);
    std::optional<btVector3> found;
    btScalar least = BT_LARGE_FLOAT;
    forEachVertex(*part.shape, [&](const btVector3& own) {
        const btVector3 vertex = to_frame * own;
        if (side * vertex[axis] >= least) return;
        least = side * vertex[axis];
        found = vertex;
    });
    return found;
}

/// Where a hull is over one face of a box, or in it. False if nothing changes.
bool straighten(const ConvexPart& box, const ConvexPart& hull, bool box_is_a, btManifoldPoint& point) {
    const btVector3 out_of_box = box_is_a ? -point.m_normalWorldOnB : point.m_normalWorldOnB;
    const btVector3 normal = out_of_box * box.transform.getBasis();
    const int axis = normal.absolute().maxAxis();
    const btScalar side = normal[axis] > 0 ? btScalar(1) : btScalar(-1);
    if (side * normal[axis] > 1 - exact || side * normal[axis] < of_face) return false;
    const btVector3 half = static_cast<const btBoxShape*>(box.shape)->getHalfExtentsWithMargin();
    const auto lowest_vertex = lowest(hull, box.transform, axis, side);
    if (!lowest_vertex) return false;
    btVector3 vertex = *lowest_vertex;
    vertex[axis] -= side * marginAround(*hull.shape);
    const btScalar distance = side * vertex[axis] - half[axis];
    if (-distance > half[axis]) return false;
    for (int i = 0; i < 3; ++i)
        if (i != axis && half[i] - std::abs(vertex[i]) <= std::abs(distance)) return false;
    btVector3 face(0, 0, 0);
    face[axis] = side;
    const btVector3 outward = box.transform.getBasis() * face, on_hull = box.transform * vertex,
                    on_box = on_hull - distance * outward;
    point.m_normalWorldOnB = box_is_a ? -outward : outward;
    point.m_positionWorldOnA = box_is_a ? on_box : on_hull;
    point.m_positionWorldOnB = box_is_a ? on_hull : on_box;
    point.m_distance1 = distance;
    return true;
}

}  // namespace

std::unique_ptr<btPersistentManifold> onBoxFaces(const btPersistentManifold& manifold,
                                                 const btTransform& stood_a, const btTransform& stood_b) {
    std::unique_ptr<btPersistentManifold> straight;
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        btManifoldPoint point = manifold.getContactPoint(i);
        const ConvexPart a = partOf(*manifold.getBody0(), stood_a, point.m_index0),
                         b = partOf(*manifold.getBody1(), stood_b, point.m_index1);
        if (!a.shape || !b.shape || isBox(a) == isBox(b)) continue;
        if (!(isBox(a) ? straighten(a, b, true, point) : straighten(b, a, false, point))) continue;
        if (!straight) straight = std::make_unique<btPersistentManifold>(manifold);
        straight->getContactPoint(i) = point;
    }
    return straight;
}

}  // namespace sherd
