#include "bullet/even_ground.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "bullet/ground_surface.h"

namespace sherd {

namespace {

constexpr btScalar beside = btScalar(1e-5);   // m; on the side of a facet is over it
constexpr btScalar even = btScalar(0.99);     // cosine of what facets may be tilted by
constexpr btScalar tilted = btScalar(0.15);   // more than its sine
constexpr btScalar parallel = btScalar(0.9);  // cosine between a normal of Bullet's and the ground's
constexpr std::size_t most_facets = 256;      // more take longer than they are worth

Facet placed(const btVector3& normal, btScalar height, const btTransform& frame) {
    Facet facet;
    facet.normal = frame.getBasis() * normal;
    facet.height = height + facet.normal.dot(frame.getOrigin());
    return facet;
}

/// The face of a box that the middle of a part is least deep in, if all of the part is over it.
std::optional<Facet> faceBelow(const ConvexPart& part, const btBoxShape& box, const btTransform& frame) {
    btVector3 low, high;
    part.shape->getAabb(frame.inverseTimes(part.transform), low, high);
    const btVector3 half = box.getHalfExtentsWithMargin(), middle = (low + high) / 2;
    const int axis = (middle.absolute() - half).maxAxis();
    for (int i = 0; i < 3; ++i)
        if (i != axis && (low[i] < -half[i] || high[i] > half[i])) return std::nullopt;
    btVector3 normal(0, 0, 0);
    normal[axis] = middle[axis] < 0 ? btScalar(-1) : btScalar(1);
    return placed(normal, half[axis], frame);
}

std::optional<Facet> endlessFacet(const ConvexPart& part, const btCollisionObject& ground, int child) {
    const btTransform& frame = ground.getWorldTransform();
    const btCollisionShape& shape = *ground.getCollisionShape();
    if (shape.getShapeType() == STATIC_PLANE_PROXYTYPE) {
        const auto& plane = static_cast<const btStaticPlaneShape&>(shape);
        return placed(plane.getPlaneNormal(), plane.getPlaneConstant(), frame);
    }
    const ConvexPart below = partOf(ground, frame, child);
    if (!below.shape || below.shape->getShapeType() != BOX_SHAPE_PROXYTYPE) return std::nullopt;
    return faceBelow(part, static_cast<const btBoxShape&>(*below.shape), below.transform);
}

btVector3 normalOf(const std::array<btVector3, 3>& corners) {
    const btVector3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    return normal.fuzzyZero() ? btVector3(0, 0, 0) : normal.normalized();
}

/// A triangle with its sides along `axis`: those of neighbours are the same, whatever their normals are.
Facet facetOf(const std::array<btVector3, 3>& corners, const btVector3& normal, const btVector3& axis) {
    const btScalar turn = normal.dot(axis) < 0 ? btScalar(-1) : btScalar(1);
    Facet facet;
    facet.normal = turn * normal;
    facet.height = facet.normal.dot(corners[0]);
    for (std::size_t i = 0; i < 3; ++i) {
        const btVector3 side = corners[(i + 1) % 3] - corners[i];
        facet.inward[i] = turn * axis.cross(side).normalized();
        facet.from[i] = facet.inward[i].dot(corners[i]) - beside;
    }
    return facet;
}

/// The same, seen from the other side.
void turnOver(Facet& facet) {
    facet.normal = -facet.normal;
    facet.height = -facet.height;
}

/// The triangles around a part, seen from the side where `inside` is and without those that are beyond it.
/// None if they are not even, or too many.
EvenGround evenTriangles(const ConvexPart& part, const btCollisionObject& surface, const btVector3& inside,
                         btScalar around) {
    btVector3 low, high;
    part.shape->getAabb(part.transform, low, high);
    const btVector3 more(around, around, around);
    EvenGround ground;
    std::vector<btVector3> ways;  // from `inside` to each facet
    bool is_even = true;
    forEachTriangle(surface, low - more, high + more, [&](const std::array<btVector3, 3>& corners) {
        const btVector3 normal = normalOf(corners);
        if (!is_even || normal.isZero()) return;
        if (ground.facets.empty()) ground.up = normal;
        is_even = ground.facets.size() < most_facets && btFabs(normal.dot(ground.up)) > even;
        ground.facets.push_back(facetOf(corners, normal, ground.up));
        ways.push_back(nearestOf(corners, inside) - inside);
    });
    if (!is_even || ways.empty()) return {};
    const btVector3 down = *std::min_element(
        ways.begin(), ways.end(), [](const auto& a, const auto& b) { return a.length2() < b.length2(); });
    if (down.dot(ground.up) > 0) {
        ground.up = -ground.up;
        std::for_each(ground.facets.begin(), ground.facets.end(), turnOver);
    }
    std::vector<Facet> facets;
    for (std::size_t i = 0; i < ways.size(); ++i)
        if (!(ways[i].dot(ground.up) > tilted * ways[i].length())) facets.push_back(ground.facets[i]);
    ground.facets = std::move(facets);
    return ground;
}

/// Whether Bullet found that ground, too: the number of a part of a compound in a compound is not that of one
/// of its own parts.
bool agrees(const btPersistentManifold& manifold, bool part_is_a, const Facet& facet) {
    constexpr btScalar parallel = btScalar(0.9);
    for (int p = 0; p < manifold.getNumContacts(); ++p) {
        const btManifoldPoint& point = manifold.getContactPoint(p);
        const btVector3& place = part_is_a ? point.m_positionWorldOnB : point.m_positionWorldOnA;
        const btVector3 up = part_is_a ? point.m_normalWorldOnB : -point.m_normalWorldOnB;
        if (up.dot(facet.normal) > parallel &&
            btFabs(facet.above(place)) < manifold.getContactBreakingThreshold())
            return true;
    }
    return false;
}

}  // namespace

bool Facet::isUnder(const btVector3& place) const {
    for (std::size_t i = 0; i < inward.size(); ++i)
        if (!(inward[i].dot(place) > from[i])) return false;
    return true;
}

const Facet* EvenGround::under(const btVector3& place) const {
    const Facet* highest = nullptr;
    btScalar least = BT_LARGE_FLOAT;
    for (const Facet& facet : facets) {
        const btScalar above = facet.above(place);
        if (!(above < least) || !facet.isUnder(place)) continue;
        least = above;
        highest = &facet;
    }
    return highest;
}

EvenGround evenGround(const ConvexPart& part, const btPersistentManifold& manifold, bool part_is_a,
                      const btVector3& inside) {
    const btCollisionObject& object = part_is_a ? *manifold.getBody1() : *manifold.getBody0();
    if (isGroundSurface(object))
        return evenTriangles(part, object, inside, manifold.getContactBreakingThreshold());
    const btManifoldPoint& first = manifold.getContactPoint(0);
    const auto facet = endlessFacet(part, object, part_is_a ? first.m_index1 : first.m_index0);
    if (!facet || !agrees(manifold, part_is_a, *facet)) return {};
    return {facet->normal, {*facet}};
}

}  // namespace sherd
