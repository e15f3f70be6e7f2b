#include "bullet/rigid_body_factory.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <LinearMath/btDefaultMotionState.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "bullet/conversions.h"
#include "bullet/convex_decomposition.h"
#include "bullet/convex_hull.h"

namespace sherd {

namespace {

constexpr double diagonal_enough =
    1e-6;  // off-diagonal part of the inertia, relative, below which axes are kept
constexpr double margin_share =
    0.02;  // of the smallest half extent: Bullet's default of 4 cm exceeds a cup's wall
constexpr int most_hull_vertices = 96;  // Bullet wants fewer than 100
constexpr double smallest_relative_volume =
    1e-7;                              // volume over the cube of the length; a smaller hull counts as flat
constexpr double detail_share = 0.25;  // of the wall thickness; convex parts ignore smaller details

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
    for (const Vec3& vertex : surface.vertices) result.vertices.push_back(turn * vertex + offset);
    return result;
}

std::unique_ptr<btCollisionShape> hullShape(const std::vector<Vec3>& vertices) {
    auto hull = std::make_unique<btConvexHullShape>();
    Eigen::AlignedBox3d box;
    for (const Vec3& vertex : vertices) {
        box.extend(vertex);
        hull->addPoint(toBullet(vertex), false);
    }
    hull->setMargin(static_cast<btScalar>(margin_share * box.sizes().minCoeff() / 2));
    hull->recalcLocalAabb();
    return hull;
}

bool isSolid(const ConvexHull& hull) {
    Eigen::AlignedBox3d box;
    for (const Vec3& vertex : hull.vertices) box.extend(vertex);
    return hull.vertices.size() >= 4 &&
           hull.volume > smallest_relative_volume * std::pow(box.diagonal().norm(), 3);
}

/// One hull; nothing if it is flat.
OwnedShape oneHull(const TriangleMesh& surface) {
    const ConvexHull hull = roughHull(surface.vertices, most_hull_vertices);
    OwnedShape owned;
    if (isSolid(hull)) owned.shape = hullShape(hull.vertices);
    return owned;
}

/// Hulls of the parts that are not flat; nothing if all are.
OwnedShape hullsOfParts(const TriangleMesh& surface, double smallest_detail_m) {
    OwnedShape owned;
    auto compound = std::make_unique<btCompoundShape>();
    for (const ConvexHull& part : convexDecomposition(surface, smallest_detail_m)) {
        if (!isSolid(part)) continue;
        owned.children.push_back(hullShape(part.vertices));
        compound->addChildShape(btTransform::getIdentity(), owned.children.back().get());
    }
    if (!owned.children.empty()) owned.shape = std::move(compound);
    return owned;
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

OwnedShape makeShape(const BreakableSolid& solid, CollisionShape wanted, const std::vector<Box>& boxes,
                     const btTransform& body_from_asset) {
    if (wanted == CollisionShape::boxes && !boxes.empty()) return boxCompound(boxes, body_from_asset);
    const TriangleMesh surface = placed(solid.surface(), body_from_asset);
    OwnedShape owned = wanted == CollisionShape::convex_parts
                           ? hullsOfParts(surface, detail_share * solid.wallThickness())
                           : oneHull(surface);
    if (owned.shape) return owned;
    if (!boxes.empty()) return boxCompound(boxes, body_from_asset);
    owned.shape = hullShape(roughHull(surface.vertices, most_hull_vertices).vertices);
    return owned;
}

OwnedBody makeRigidBody(const BreakableSolid& solid, CollisionShape wanted, const std::vector<Box>& boxes,
                        double mass_scale) {
    const PrincipalFrame frame = principalFrame(solid.moments());
    const double density = mass_scale * solid.material().density_kg_m3;
    OwnedBody owned;
    owned.shape = makeShape(solid, wanted, boxes, frame.body_from_asset);
    const btRigidBody::btRigidBodyConstructionInfo info(static_cast<btScalar>(mass_scale * solid.mass()),
                                                        nullptr, owned.shape.shape.get(),
                                                        toBullet(Vec3(density * frame.inertia)));
    owned.body = std::make_unique<btRigidBody>(info);
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
