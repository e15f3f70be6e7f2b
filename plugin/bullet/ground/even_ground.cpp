#include "bullet/ground/even_ground.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <optional>

#include "bullet/ground/ground_surface.h"
#include "bullet/shapes/flat_face.h"

namespace sherd {

namespace {

constexpr btScalar beside_m = btScalar(1e-5);  // m; on the side of a facet is over it, but for rounding
constexpr btScalar ridge_m = btScalar(2e-3);   // into a part that lies on it: hardly matters
constexpr btScalar level = btScalar(1e-3), tilted = btScalar(0.14);  // sines: hardly and most tilted
constexpr btScalar steep = btScalar(0.5);     // cosine from which on a triangle is a wall beside the ground
constexpr btScalar facing = btScalar(0.999);  // cosine between a normal and the way to what is over it
constexpr btScalar touching_m = btScalar(1e-3);
constexpr std::size_t most_triangles = 256;  // more take longer than they are worth

const btVector3& placeOnGround(const btManifoldPoint& point, bool part_is_a) {
    return part_is_a ? point.m_positionWorldOnB : point.m_positionWorldOnA;
}

Facet placed(const btVector3& normal, btScalar height, const btTransform& frame) {
    Facet facet;
    facet.normal = frame.getBasis() * normal;
    facet.height = height + facet.normal.dot(frame.getOrigin());
    return facet;
}

/// The face of a box that the middle of a part is least deep in, if all of the part is over it.
std::optional<Facet> faceBelow(const PlacedShape& part, const btBoxShape& box, const btTransform& frame) {
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

/// The face of a hull or a cylinder that Bullet found, if all of the part is over it.
std::optional<Facet> faceFound(const PlacedShape& part, const PlacedShape& below,
                               const btPersistentManifold& manifold, bool part_is_a) {
    for (int p = 0; p < manifold.getNumContacts(); ++p) {
        const btVector3& normal = manifold.getContactPoint(p).m_normalWorldOnB;
        const auto face = faceTowards(below, part_is_a ? normal : -normal);
        if (!face || !face->isUnder(part)) continue;
        Facet facet;
        facet.normal = face->normal;
        facet.height = face->height;
        return facet;
    }
    return std::nullopt;
}

std::optional<Facet> endlessFacet(const PlacedShape& part, const btPersistentManifold& manifold,
                                  bool part_is_a, const btTransform& frame, bool of_hulls) {
    const btCollisionObject& ground = part_is_a ? *manifold.getBody1() : *manifold.getBody0();
    const btManifoldPoint& first = manifold.getContactPoint(0);
    const PlacedShape below = childOf(ground, frame, part_is_a ? first.m_index1 : first.m_index0);
    if (!below.shape) return std::nullopt;
    switch (below.shape->getShapeType()) {
        case STATIC_PLANE_PROXYTYPE: {
            const auto& plane = static_cast<const btStaticPlaneShape&>(*below.shape);
            return placed(plane.getPlaneNormal(), plane.getPlaneConstant(), below.transform);
        }
        case BOX_SHAPE_PROXYTYPE:
            return faceBelow(part, static_cast<const btBoxShape&>(*below.shape), below.transform);
        default:
            return of_hulls ? faceFound(part, below, manifold, part_is_a) : std::nullopt;
    }
}

struct Triangle {
    std::array<btVector3, 3> corners;
    btVector3 normal;
};

/// Those that may reach into a box and have an area; none if there are too many.
std::vector<Triangle> trianglesIn(const btVector3& low, const btVector3& high,
                                  const btCollisionObject& surface) {
    std::vector<Triangle> triangles;
    forEachTriangle(surface, low, high, [&](const std::array<btVector3, 3>& corners) {
        if (triangles.size() > most_triangles) return;
        const btVector3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        if (!normal.fuzzyZero()) triangles.push_back({corners, normal.normalized()});
    });
    if (triangles.size() > most_triangles) triangles.clear();
    return triangles;
}

/// A triangle with its sides along `axis`, which is not along it: neighbours have the same ones, whatever
/// their normals are.
Facet facetOf(const Triangle& triangle, const btVector3& axis) {
    const btScalar turn = triangle.normal.dot(axis) < 0 ? btScalar(-1) : btScalar(1);
    const auto& corners = triangle.corners;
    Facet facet;
    facet.normal = turn * triangle.normal;
    facet.height = facet.normal.dot(corners[0]);
    for (std::size_t i = 0; i < 3; ++i) {
        const btVector3 side = corners[(i + 1) % 3] - corners[i];
        const btScalar rounding = 4 * SIMD_EPSILON * corners[i].length();
        facet.inward[i] = turn * axis.cross(side).normalized();
        facet.from[i] = facet.inward[i].dot(corners[i]) - beside_m - rounding;
    }
    return facet;
}

/// Whether one of some contacts is on a triangle.
bool isTouched(const Triangle& triangle, const std::vector<btVector3>& contacts) {
    const Facet facet = facetOf(triangle, triangle.normal);
    return std::any_of(contacts.begin(), contacts.end(), [&](const btVector3& place) {
        return btFabs(facet.above(place)) < touching_m && facet.isUnder(place);
    });
}

/// The triangle that a point is over: one that is touched if there is any, and else the nearest; its normal
/// is turned to the side of the point. Nothing if the point is over none, or on it.
std::optional<Triangle> triangleUnder(const btVector3& point, const std::vector<Triangle>& triangles,
                                      const std::vector<btVector3>& contacts) {
    std::optional<Triangle> best;
    bool is_best_touched = false;
    btScalar least = BT_LARGE_FLOAT;
    for (const Triangle& triangle : triangles) {
        const btVector3 way = point - nearestOf(triangle.corners, point);
        const btScalar above = way.dot(triangle.normal);
        if (way.fuzzyZero() || !(btFabs(above) > facing * way.length())) continue;
        const bool is_touched = isTouched(triangle, contacts);
        if (is_touched == is_best_touched ? !(way.length2() < least) : is_best_touched) continue;
        best = triangle;
        if (above < 0) best->normal = -best->normal;
        is_best_touched = is_touched;
        least = way.length2();
    }
    return best;
}

/// The sine of what triangles beside a ridge may be tilted by: wide parts sink further on it, where they have
/// no vertices.
btScalar mostTilted(const btVector3& extents) {
    return btClamped(2 * ridge_m / extents.length(), level, tilted);
}

/// The triangles under a part, seen from the side where `inside` is, or the middle of the part if that is
/// over none; without those that are beyond it, and without walls that nothing touches. None if they are not
/// even.
EvenGround evenTriangles(const PlacedShape& part, const btCollisionObject& surface, btScalar around,
                         const std::vector<btVector3>& contacts, btVector3 inside) {
    btVector3 low, high;
    part.shape->getAabb(part.transform, low, high);
    const btVector3 more(around, around, around);
    const std::vector<Triangle> triangles = trianglesIn(low - more, high + more, surface);
    const btScalar most_tilted = mostTilted(high - low);
    auto below = triangleUnder(inside, triangles, contacts);
    if (!below) {
        inside = (low + high) / 2;
        below = triangleUnder(inside, triangles, contacts);
    }
    if (!below) return {};
    EvenGround ground;
    ground.up = below->normal;
    const btScalar height = ground.up.dot(below->corners[0]);
    for (const Triangle& triangle : triangles) {
        const btScalar cosine = btFabs(triangle.normal.dot(ground.up));
        if (cosine < steep && !isTouched(triangle, contacts)) continue;
        const bool is_in_valley =
            std::all_of(triangle.corners.begin(), triangle.corners.end(),
                        [&](const btVector3& corner) { return ground.up.dot(corner) > height - beside_m; });
        const btScalar squared_sine = 1 - cosine * cosine;
        if (squared_sine > tilted * tilted) return {};
        ground.has_ridges |= !is_in_valley && squared_sine > most_tilted * most_tilted;
        const btVector3 way = nearestOf(triangle.corners, inside) - inside;
        const bool is_beyond = way.dot(ground.up) > 2 * tilted * way.length();
        if (!is_beyond) ground.facets.push_back(facetOf(triangle, ground.up));
    }
    return ground;
}

/// Whether Bullet found that ground, and none on its other side: a kinematic box may come to lie around what
/// lay on it. The number of a part of a compound in a compound is not that of one of its own parts.
bool agrees(const btPersistentManifold& manifold, bool part_is_a, const Facet& facet) {
    constexpr btScalar parallel = btScalar(0.9);
    bool is_found = false;
    for (int p = 0; p < manifold.getNumContacts(); ++p) {
        const btManifoldPoint& point = manifold.getContactPoint(p);
        const btVector3& place = placeOnGround(point, part_is_a);
        const btVector3 up = part_is_a ? point.m_normalWorldOnB : -point.m_normalWorldOnB;
        if (up.dot(facet.normal) < -parallel) return false;
        is_found |= up.dot(facet.normal) > parallel &&
                    btFabs(facet.above(place)) < manifold.getContactBreakingThreshold();
    }
    return is_found;
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

EvenGround evenGround(const PlacedShape& part, const btPersistentManifold& manifold, bool part_is_a,
                      const btTransform& ground_stood, const btVector3& inside, bool of_hulls) {
    const btCollisionObject& object = part_is_a ? *manifold.getBody1() : *manifold.getBody0();
    const btManifoldPoint& first = manifold.getContactPoint(0);
    if (isOnTriangle(first, part_is_a)) {
        if (!isGroundSurface(object)) return {};
        std::vector<btVector3> contacts;
        for (int p = 0; p < manifold.getNumContacts(); ++p)
            contacts.push_back(placeOnGround(manifold.getContactPoint(p), part_is_a));
        return evenTriangles(part, object, manifold.getContactBreakingThreshold(), contacts, inside);
    }
    const auto facet = endlessFacet(part, manifold, part_is_a, ground_stood, of_hulls);
    if (!facet || !agrees(manifold, part_is_a, *facet)) return {};
    return {facet->normal, {*facet}, false};
}

EvenGround evenSurface(const PlacedShape& part, const btCollisionObject& surface, const btVector3& inside) {
    return evenTriangles(part, surface, 0, {}, inside);
}

}  // namespace sherd
