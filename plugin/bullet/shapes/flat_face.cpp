#include "bullet/shapes/flat_face.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>

#include <algorithm>
#include <cmath>

#include "core/loads/convex_hull_2d.h"

namespace sherd {

namespace {

constexpr btScalar near_cosine = btScalar(0.996);  // of 5 degrees

/// Points that turn round a normal, each pair of neighbours of which is a side.
std::vector<FaceSide> sidesOf(const std::vector<btVector3>& outline, const btVector3& normal) {
    std::vector<FaceSide> sides;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const btVector3 inward = normal.cross(outline[(i + 1) % outline.size()] - outline[i]);
        if (inward.fuzzyZero()) continue;
        sides.push_back({inward.normalized(), inward.normalized().dot(outline[i])});
    }
    return sides;
}

/// The corners of a face without what lies between them, in their order round its normal.
std::vector<btVector3> outlineOf(const std::vector<btVector3>& points, const btVector3& normal) {
    btVector3 x, y;
    btPlaneSpace1(normal, x, y);
    std::vector<Vec2> seen;
    for (const btVector3& point : points) seen.emplace_back(x.dot(point), y.dot(point));
    const btScalar height = normal.dot(points.front());
    std::vector<btVector3> outline;
    for (const Vec2& corner : convexHull(seen))
        outline.push_back(btScalar(corner.x()) * x + btScalar(corner.y()) * y + height * normal);
    return outline;
}

/// Of ways from a corner that is furthest along a direction the one to which a plane comes first that tilts
/// about that corner, or about an axis through it: where several do, the longest. `slopeAlong` gives how far
/// a way goes along the plane. Those that are no deeper than `flat` are in the plane.
template <class Along>
const btVector3* firstMet(const std::vector<btVector3>& ways, const btVector3& direction, btScalar flat,
                          const Along& along) {
    const btVector3* first = nullptr;
    btScalar least = BT_LARGE_FLOAT, longest = 0;
    for (const btVector3& way : ways) {
        const btScalar length = along(way);
        if (!(length > flat)) continue;
        const btScalar slope = std::max(-direction.dot(way) - flat, btScalar(0)) / length;
        if (slope > least || (slope == least && length <= longest)) continue;
        least = slope;
        longest = length;
        first = &way;
    }
    return first;
}

/// The normal of a face that has the corner which is furthest along a direction, from which the ways go: of
/// the two beside the edge that a plane meets first the one that faces there more. Nothing if it is a point,
/// a line, or has no face.
std::optional<btVector3> normalOfFace(const std::vector<btVector3>& ways, const btVector3& direction,
                                      btScalar flat) {
    const btVector3* edge = firstMet(ways, direction, flat, [&](const btVector3& way) {
        return (way - direction * direction.dot(way)).length();
    });
    if (!edge) return std::nullopt;
    const btVector3 axis = edge->normalized();
    const btVector3 tilted = (direction - axis * axis.dot(direction)).normalized(),
                    across = tilted.cross(axis);
    std::optional<btVector3> best;
    for (const btScalar side : {btScalar(1), btScalar(-1)}) {
        const btVector3* other =
            firstMet(ways, tilted, flat, [&](const btVector3& way) { return side * across.dot(way); });
        if (!other) continue;
        const btVector3 normal = (side * axis.cross(*other)).normalized();
        if (!best || normal.dot(direction) > best->dot(direction)) best = normal;
    }
    return best;
}

/// A face that has the corner which is furthest along a direction.
std::optional<FlatFace> faceOfHull(const btPolyhedralConvexShape& shape, const btVector3& direction) {
    constexpr btScalar flatness = btScalar(2e-4);  // of its diagonal
    std::vector<btVector3> vertices;
    forEachVertex(shape, [&](const btVector3& vertex) { vertices.push_back(vertex); });
    if (vertices.empty()) return std::nullopt;
    btVector3 low = vertices.front(), high = low, furthest = low;
    for (const btVector3& vertex : vertices) {
        low.setMin(vertex);
        high.setMax(vertex);
        if (direction.dot(vertex) > direction.dot(furthest)) furthest = vertex;
    }
    const btScalar flat = flatness * (high - low).length();
    std::vector<btVector3> ways;
    for (const btVector3& vertex : vertices) ways.push_back(vertex - furthest);
    const auto normal = normalOfFace(ways, direction, flat);
    if (!normal || !(normal->dot(direction) > near_cosine)) return std::nullopt;
    std::vector<btVector3> on_it;
    for (const btVector3& vertex : vertices)
        if (btFabs(normal->dot(vertex - furthest)) < 2 * flat) on_it.push_back(vertex);
    const std::vector<btVector3> outline = outlineOf(on_it, *normal);
    if (outline.size() < 3) return std::nullopt;
    btScalar highest = -BT_LARGE_FLOAT, lowest = BT_LARGE_FLOAT;
    for (const btVector3& vertex : vertices) {
        highest = std::max(highest, normal->dot(vertex));
        lowest = std::min(lowest, normal->dot(vertex));
    }
    FlatFace face;
    face.normal = *normal;
    face.height = highest + marginAround(shape);
    face.thickness = highest - lowest;
    face.sides = sidesOf(outline, *normal);
    return face;
}

/// Without sides: of a box or a cylinder with these half extents the end along an axis.
std::optional<FlatFace> endAcross(int axis, const btVector3& half, const btVector3& direction) {
    FlatFace face;
    face.normal.setZero();
    face.normal[axis] = direction[axis] < 0 ? btScalar(-1) : btScalar(1);
    if (!(face.normal.dot(direction) > near_cosine)) return std::nullopt;
    face.height = half[axis];
    face.thickness = 2 * half[axis];
    return face;
}

std::optional<FlatFace> faceOfBox(const btBoxShape& box, const btVector3& direction) {
    const btVector3 half = box.getHalfExtentsWithMargin();
    const int axis = direction.absolute().maxAxis();
    auto face = endAcross(axis, half, direction);
    if (!face) return std::nullopt;
    for (int i = 0; i < 3; ++i) {
        if (i == axis) continue;
        btVector3 inward(0, 0, 0);
        for (const btScalar side : {btScalar(-1), btScalar(1)}) {
            inward[i] = side;
            face->sides.push_back({inward, -half[i]});
        }
    }
    return face;
}

std::optional<FlatFace> faceOfCylinder(const btCylinderShape& cylinder, const btVector3& direction) {
    constexpr int corners = 32;
    const btVector3 half = cylinder.getHalfExtentsWithMargin();
    const int up = cylinder.getUpAxis(), x = (up + 1) % 3, y = (up + 2) % 3;
    auto face = endAcross(up, half, direction);
    if (!face) return std::nullopt;
    std::vector<btVector3> outline;
    for (int i = 0; i < corners; ++i) {
        const btScalar angle = face->normal[up] * btScalar(i) * SIMD_2_PI / corners;
        btVector3 corner(0, 0, 0);
        corner[x] = half[x] * btCos(angle);
        corner[y] = half[y] * btSin(angle);
        outline.push_back(corner);
    }
    face->sides = sidesOf(outline, face->normal);
    return face;
}

/// In the part's frame, as the direction.
std::optional<FlatFace> ownFace(const btCollisionShape& shape, const btVector3& direction) {
    switch (shape.getShapeType()) {
        case STATIC_PLANE_PROXYTYPE: {
            const auto& plane = static_cast<const btStaticPlaneShape&>(shape);
            if (!(plane.getPlaneNormal().dot(direction) > near_cosine)) return std::nullopt;
            return FlatFace{plane.getPlaneNormal(), plane.getPlaneConstant()};
        }
        case BOX_SHAPE_PROXYTYPE:
            return faceOfBox(static_cast<const btBoxShape&>(shape), direction);
        case CYLINDER_SHAPE_PROXYTYPE:
            return faceOfCylinder(static_cast<const btCylinderShape&>(shape), direction);
        default:
            if (!shape.isPolyhedral()) return std::nullopt;
            return faceOfHull(static_cast<const btPolyhedralConvexShape&>(shape), direction);
    }
}

}  // namespace

bool FlatFace::isUnder(const btVector3& place) const {
    return std::all_of(sides.begin(), sides.end(),
                       [&](const FaceSide& side) { return side.inward.dot(place) >= side.from; });
}

btScalar FlatFace::roomAround(const btVector3& place) const {
    btScalar room = BT_LARGE_FLOAT;
    for (const FaceSide& side : sides) room = std::min(room, side.inward.dot(place) - side.from);
    return std::max(room, btScalar(0));
}

bool FlatFace::isUnder(const PlacedShape& other) const {
    return std::all_of(sides.begin(), sides.end(), [&](const FaceSide& side) {
        const btVector3 along = normal.cross(side.inward);
        const btMatrix3x3 to_side(side.inward.x(), side.inward.y(), side.inward.z(), along.x(), along.y(),
                                  along.z(), normal.x(), normal.y(), normal.z());
        btVector3 low, high;
        other.shape->getAabb(btTransform(to_side) * other.transform, low, high);
        return low.x() >= side.from;
    });
}

std::optional<FlatFace> faceTowards(const PlacedShape& part, const btVector3& direction) {
    if (!part.shape) return std::nullopt;
    const btMatrix3x3& basis = part.transform.getBasis();
    auto face = ownFace(*part.shape, direction * basis);
    if (!face) return std::nullopt;
    face->normal = basis * face->normal;
    face->height += face->normal.dot(part.transform.getOrigin());
    for (FaceSide& side : face->sides) {
        side.inward = basis * side.inward;
        side.from += side.inward.dot(part.transform.getOrigin());
    }
    return face;
}

}  // namespace sherd
