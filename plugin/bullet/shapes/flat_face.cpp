#include "bullet/shapes/flat_face.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sherd {

namespace {

constexpr btScalar near_cosine = btScalar(0.996);  // of 5 degrees
constexpr std::size_t most_corners = 100;

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

/// Points of a face in their order round its normal.
std::vector<btVector3> inOrder(const std::vector<btVector3>& corners, const btVector3& normal) {
    btVector3 middle(0, 0, 0), x, y;
    for (const btVector3& corner : corners) middle += corner / btScalar(corners.size());
    btPlaneSpace1(normal, x, y);
    std::vector<std::pair<btScalar, std::size_t>> angles;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const btVector3 way = corners[i] - middle;
        angles.emplace_back(std::atan2(y.dot(way), x.dot(way)), i);
    }
    std::sort(angles.begin(), angles.end());
    std::vector<btVector3> ordered;
    for (const auto& [angle, i] : angles) ordered.push_back(corners[i]);
    return ordered;
}

/// At right angles to a polygon, with the length of twice its area.
btVector3 areaOf(const std::vector<btVector3>& outline) {
    btVector3 area(0, 0, 0);
    for (std::size_t i = 2; i < outline.size(); ++i)
        area += (outline[i - 1] - outline[0]).cross(outline[i] - outline[0]);
    return area;
}

/// The normal of the plane through the origin and two of some points that is nearest to a direction and has
/// all points below it, but for `flat`; nothing if none is near.
std::optional<btVector3> planeOver(const std::vector<btVector3>& points, const btVector3& direction,
                                   btScalar flat) {
    constexpr btScalar in_line = btScalar(1e-3);  // sine of an angle between ways that tell no plane
    std::optional<btVector3> best;
    btScalar nearest = near_cosine;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = i + 1; j < points.size(); ++j) {
            btVector3 normal = points[i].cross(points[j]);
            const btScalar area = normal.length();
            if (!(area > in_line * points[i].length() * points[j].length())) continue;
            normal *= (normal.dot(direction) < 0 ? -1 : 1) / area;
            const btScalar cosine = normal.dot(direction);
            if (!(cosine > nearest)) continue;
            const bool is_over = std::none_of(points.begin(), points.end(),
                                              [&](const btVector3& way) { return normal.dot(way) > flat; });
            if (!is_over) continue;
            nearest = cosine;
            best = normal;
        }
    return best;
}

/// A face that has the corner which is furthest along a direction.
std::optional<FlatFace> faceOfHull(const btPolyhedralConvexShape& shape, const btVector3& direction) {
    std::vector<btVector3> vertices;
    forEachVertex(shape, [&](const btVector3& vertex) { vertices.push_back(vertex); });
    if (vertices.empty()) return std::nullopt;
    btVector3 low = vertices.front(), high = low, furthest = low;
    for (const btVector3& vertex : vertices) {
        low.setMin(vertex);
        high.setMax(vertex);
        if (direction.dot(vertex) > direction.dot(furthest)) furthest = vertex;
    }
    const btScalar flat = btScalar(1e-5) * (high - low).length(),
                   sine = btSqrt(1 - near_cosine * near_cosine);
    std::vector<btVector3> beside;
    for (const btVector3& vertex : vertices) {
        const btVector3 way = vertex - furthest;
        if (way.length() > flat && -direction.dot(way) < sine * way.length()) beside.push_back(way);
    }
    if (beside.size() > most_corners) return std::nullopt;
    const auto over = planeOver(beside, direction, flat);
    if (!over) return std::nullopt;
    std::vector<btVector3> corners;
    for (const btVector3& vertex : vertices)
        if (btFabs(over->dot(vertex - furthest)) < 2 * flat) corners.push_back(vertex);
    corners = inOrder(corners, *over);
    FlatFace face;
    face.normal = areaOf(corners).normalized();
    btScalar highest = -BT_LARGE_FLOAT, lowest = BT_LARGE_FLOAT;
    for (const btVector3& vertex : vertices) {
        highest = std::max(highest, face.normal.dot(vertex));
        lowest = std::min(lowest, face.normal.dot(vertex));
    }
    face.height = highest + marginAround(shape);
    face.thickness = highest - lowest;
    face.sides = sidesOf(corners, face.normal);
    return face;
}

std::optional<FlatFace> faceOfBox(const btBoxShape& box, const btVector3& direction) {
    const btVector3 half = box.getHalfExtentsWithMargin();
    const int axis = direction.absolute().maxAxis();
    FlatFace face;
    face.normal.setZero();
    face.normal[axis] = direction[axis] < 0 ? btScalar(-1) : btScalar(1);
    if (!(face.normal.dot(direction) > near_cosine)) return std::nullopt;
    face.height = half[axis];
    face.thickness = 2 * half[axis];
    for (int i = 0; i < 3; ++i) {
        if (i == axis) continue;
        btVector3 inward(0, 0, 0);
        for (const btScalar side : {btScalar(-1), btScalar(1)}) {
            inward[i] = side;
            face.sides.push_back({inward, -half[i]});
        }
    }
    return face;
}

std::optional<FlatFace> faceOfCylinder(const btCylinderShape& cylinder, const btVector3& direction) {
    constexpr int corners = 32;
    const btVector3 half = cylinder.getHalfExtentsWithMargin();
    const int up = cylinder.getUpAxis(), x = (up + 1) % 3, y = (up + 2) % 3;
    FlatFace face;
    face.normal.setZero();
    face.normal[up] = direction[up] < 0 ? btScalar(-1) : btScalar(1);
    if (!(face.normal.dot(direction) > near_cosine)) return std::nullopt;
    face.height = half[up];
    face.thickness = 2 * half[up];
    std::vector<btVector3> outline;
    for (int i = 0; i < corners; ++i) {
        const btScalar angle = face.normal[up] * btScalar(i) * SIMD_2_PI / corners;
        btVector3 corner(0, 0, 0);
        corner[x] = half[x] * btCos(angle);
        corner[y] = half[y] * btSin(angle);
        outline.push_back(corner);
    }
    face.sides = sidesOf(outline, face.normal);
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
