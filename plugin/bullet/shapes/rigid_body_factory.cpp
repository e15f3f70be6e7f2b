#include "bullet/shapes/rigid_body_factory.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <LinearMath/btDefaultMotionState.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "bullet/shapes/piece_hull.h"
#include "bullet/shapes/pooled.h"
#include "bullet/world/conversions.h"
#include "geometry/convex/convex_decomposition.h"
#include "geometry/convex/convex_hull.h"
#include "geometry/convex/corners_of_feet.h"

namespace sherd {

namespace {

struct Body final : btRigidBody, Pooled {
    using btRigidBody::btRigidBody;
    using Pooled::operator new;
    using Pooled::operator delete;
};

constexpr double diagonal_enough =
    1e-6;  // off-diagonal part of the inertia, relative, below which axes are kept
constexpr double margin_share =
    0.02;  // of the smallest half extent: Bullet's default of 4 cm exceeds a cup's wall
constexpr double least_margin = 1e-4;   // of a hull's diagonal: on thinner sheets Bullet's GJK crashes
constexpr int most_hull_vertices = 96;  // Bullet wants fewer than 100
constexpr double smallest_relative_volume =
    1e-7;  // volume over the cube of the length; a smaller hull counts as flat
constexpr int most_outermost = 1024;
constexpr double outermost_tolerance = 0.01;  // of the spacing
constexpr double nearly_convex = 0.5;  // of a solid's volume: air that a hull of an automatic shape may hold

/// Eigenvectors ordered and signed to be as near as possible to the asset's own axes, right-handed.
Mat3 nearestToIdentity(const Mat3& axes) {
    Mat3 result = Mat3::Identity();
    Eigen::Matrix<bool, 3, 1> used(false, false, false);
    for (int axis = 0; axis < 3; ++axis) {
        int best = -1;
        for (int column = 0; column < 3; ++column)
            if (!used[column] && (best < 0 || std::abs(axes(axis, column)) > std::abs(axes(axis, best))))
                best = column;
        used[best] = true;
        result.col(axis) = axes(axis, best) < 0 ? Vec3(-axes.col(best)) : Vec3(axes.col(best));
    }
    if (result.determinant() < 0) result.col(2) = -result.col(2);
    return result;
}

Mat3 principalAxes(const Mat3& inertia) {
    Mat3 off_diagonal = inertia;
    off_diagonal.diagonal().setZero();
    if (off_diagonal.norm() <= diagonal_enough * inertia.norm()) return Mat3::Identity();
    return nearestToIdentity(Eigen::SelfAdjointEigenSolver<Mat3>(inertia).eigenvectors());
}

/// The surface in the body's frame, without attributes, which shapes do not use.
TriangleMesh placed(const TriangleMesh& surface, const btTransform& body_from_asset) {
    const Mat3 turn = fromBullet(body_from_asset.getBasis());
    const Vec3 offset = fromBullet(body_from_asset.getOrigin());
    TriangleMesh result;
    result.triangles = surface.triangles;
    result.vertices.reserve(surface.vertices.size());
    for (const Vec3& vertex : surface.vertices) result.vertices.push_back(turn * vertex + offset);
    return result;
}

/// The margin lies outside the vertices, so half of what lies outside the hull goes into it.
std::unique_ptr<btCollisionShape> hullShape(const ConvexHull& hull, bool of_fragment) {
    std::unique_ptr<btConvexHullShape> shape;
    if (of_fragment)
        shape = std::make_unique<PieceHull>();
    else
        shape = std::make_unique<btConvexHullShape>();
    Eigen::AlignedBox3d box;
    for (const Vec3& vertex : hull.vertices) {
        box.extend(vertex);
        shape->addPoint(toBullet(vertex), false);
    }
    const double wanted = std::max(margin_share * box.sizes().minCoeff(), hull.outside) / 2;
    shape->setMargin(static_cast<btScalar>(std::max(wanted, least_margin * box.diagonal().norm())));
    shape->recalcLocalAabb();
    return shape;
}

bool isSolid(const ConvexHull& hull) {
    Eigen::AlignedBox3d box;
    for (const Vec3& vertex : hull.vertices) box.extend(vertex);
    return hull.vertices.size() >= 4 &&
           hull.volume > smallest_relative_volume * std::pow(box.diagonal().norm(), 3);
}

DecompositionLimits limitsOf(const ShapeChoice& wanted, double spacing_m) {
    DecompositionLimits limits;
    limits.most_vertices = most_hull_vertices;
    limits.tolerance_m = shape_tolerance * spacing_m;
    if (wanted.kind == CollisionShape::convex_parts) return limits;
    limits.most_parts = wanted.kind == CollisionShape::automatic ? wanted.most_parts : 1;
    limits.air_share_of_one_hull = nearly_convex;
    limits.air_share = nearly_convex / 4;
    return limits;
}

/// Hulls that are not flat; no shape if all are. One alone is no compound, unless convex parts are asked for.
OwnedShape shapeOf(const std::vector<ConvexHull>& hulls, bool of_fragment, bool always_compound) {
    OwnedShape owned;
    for (const ConvexHull& hull : hulls)
        if (isSolid(hull)) owned.children.push_back(hullShape(hull, of_fragment));
    if (owned.children.size() == 1 && !always_compound) {
        owned.shape = std::move(owned.children.front());
        owned.children.clear();
    } else if (!owned.children.empty()) {
        auto compound = std::make_unique<btCompoundShape>();
        for (const auto& child : owned.children)
            compound->addChildShape(btTransform::getIdentity(), child.get());
        owned.shape = std::move(compound);
    }
    return owned;
}

/// A box, where a whole body fills the one around it: boxes stand on each other in Bullet, and hulls hardly
/// do, and the margin of a box lies inside. Nothing for other bodies, and for sheets, which need a hull's
/// margin. `surface` in the body's frame, whose origin is the centre of mass.
std::unique_ptr<btCollisionShape> boxOf(const TriangleMesh& surface, const BreakableSolid& solid) {
    constexpr double filled = 1 - 1e-6;
    constexpr double margin_of_boxes = 0.05;  // of the smallest extent: Bullet's
    Eigen::AlignedBox3d box;
    for (const Vec3& vertex : surface.vertices) box.extend(vertex);
    const bool is_sheet = margin_of_boxes * box.sizes().minCoeff() < least_margin * box.diagonal().norm();
    if (solid.isFragment() || is_sheet || solid.moments().volume < filled * box.volume()) return nullptr;
    return std::make_unique<btBoxShape>(toBullet(Vec3(0.5 * box.sizes())));
}

bool holdAir(const std::vector<ConvexHull>& hulls, double solid_volume) {
    constexpr double next_to_none = 0.1;  // of the solid's volume
    double volume = 0;
    for (const ConvexHull& hull : hulls) volume += hull.volume;
    return volume > (1 + next_to_none) * solid_volume;
}

/// The vertices with which a whole body can land on a plane.
std::vector<btVector3> outermostOf(const TriangleMesh& surface, const BreakableSolid& solid) {
    if (solid.isFragment()) return {};
    const double tolerance_m = outermost_tolerance * solid.spacing();
    const std::vector<Vec3> hull = simpleHull(surface.vertices, most_outermost, tolerance_m).vertices;
    std::vector<btVector3> outermost;
    for (const Vec3& vertex : hull) outermost.push_back(toBullet(vertex));
    for (const Vec3& corner : cornersOfFeet(surface, hull, tolerance_m))
        if (std::find(hull.begin(), hull.end(), corner) == hull.end()) outermost.push_back(toBullet(corner));
    return outermost;
}

OwnedShape boxCompound(const std::vector<Box>& boxes, const btTransform& body_from_asset) {
    OwnedShape owned;
    owned.disjoint = true;
    auto compound = std::make_unique<btCompoundShape>(true, static_cast<int>(boxes.size()));
    for (const Box& box : boxes) {
        auto child = std::make_unique<btBoxShape>(toBullet(box.half_extents));
        const btTransform place(btQuaternion::getIdentity(), toBullet(box.centre));
        compound->addChildShape(body_from_asset * place, child.get());
        owned.children.push_back(std::move(child));
    }
    owned.shape = std::move(compound);
    return owned;
}

}  // namespace

PrincipalFrame principalFrame(const Moments& moments) {
    const Mat3 inertia = moments.second.trace() * Mat3::Identity() - moments.second;
    const Mat3 axes = principalAxes(inertia);
    PrincipalFrame frame;
    frame.body_from_asset = btTransform(toBullet(axes), toBullet(moments.centroid)).inverse();
    frame.inertia = (axes.transpose() * inertia * axes).diagonal();
    return frame;
}

OwnedShape makeShape(const BreakableSolid& solid, const ShapeChoice& wanted, const std::vector<Box>& boxes,
                     const btTransform& body_from_asset) {
    if (wanted.kind == CollisionShape::boxes && !boxes.empty()) return boxCompound(boxes, body_from_asset);
    const TriangleMesh surface = placed(solid.surface(), body_from_asset);
    OwnedShape owned;
    if (wanted.kind != CollisionShape::convex_parts) owned.shape = boxOf(surface, solid);
    if (owned.shape) return owned;
    const DecompositionLimits limits = limitsOf(wanted, solid.spacing());
    const std::vector<ConvexHull> hulls = convexDecomposition(surface, solid.moments().volume, limits);
    owned = shapeOf(hulls, solid.isFragment(), wanted.kind == CollisionShape::convex_parts);
    if (!owned.shape && !boxes.empty()) return boxCompound(boxes, body_from_asset);
    if (!owned.shape)
        owned.shape = hullShape(simpleHull(surface.vertices, limits.most_vertices, limits.tolerance_m),
                                solid.isFragment());
    owned.closes_hollows =
        !solid.isFragment() && wanted.kind != CollisionShape::hull && holdAir(hulls, solid.moments().volume);
    owned.outermost = outermostOf(surface, solid);
    return owned;
}

OwnedBody makeRigidBody(const BreakableSolid& solid, std::shared_ptr<const OwnedShape> shape,
                        double mass_scale) {
    const double density = mass_scale * solid.material().density_kg_m3;
    OwnedBody owned;
    owned.shape = std::move(shape);
    const btRigidBody::btRigidBodyConstructionInfo info(
        static_cast<btScalar>(mass_scale * solid.mass()), nullptr, owned.shape->shape.get(),
        toBullet(Vec3(density * principalFrame(solid.moments()).inertia)));
    owned.body = std::make_unique<Body>(info);
    return owned;
}

void placeBody(OwnedBody& owned, const btTransform& place, const btTransform& drawn,
               const btTransform& body_from_asset) {
    owned.motion_state = std::make_unique<btDefaultMotionState>(drawn * body_from_asset, body_from_asset);
    // This moves the body to where the motion state says, up to rounding.
    owned.body->setMotionState(owned.motion_state.get());
    owned.body->setCenterOfMassTransform(place);
}

btTransform renderedTransform(const btRigidBody& body) {
    btTransform drawn = body.getWorldTransform();
    if (const btMotionState* motion_state = body.getMotionState()) motion_state->getWorldTransform(drawn);
    return drawn;
}

}  // namespace sherd
