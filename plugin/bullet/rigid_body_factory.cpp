#include "rigid_body_factory.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>

#include <Eigen/Eigenvalues>

#include "conversions.h"
#include "shapes.h"

namespace sherd {

namespace {

constexpr double kDiagonalEnough =
    1e-6;  // off-diagonal part of the inertia, relative, below which axes are kept
constexpr double kMarginShare = 0.02;  // of the smallest half extent: Bullet's 4 cm swallow a cup's wall

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
    if (off_diagonal.norm() <= kDiagonalEnough * inertia.norm()) return Mat3::Identity();
    return nearestToIdentity(Eigen::SelfAdjointEigenSolver<Mat3>(inertia).eigenvectors());
}

OwnedShape hullShape(const TriangleMesh& surface, const btTransform& body_from_asset) {
    btConvexHullShape all;
    all.setMargin(0);
    for (const Vec3& vertex : surface.vertices) all.addPoint(body_from_asset * toBullet(vertex), false);
    all.recalcLocalAabb();
    auto hull = std::make_unique<btConvexHullShape>();
    for (const Vec3& point : supportPoints(all)) hull->addPoint(toBullet(point), false);
    btVector3 low, high;
    all.getAabb(btTransform::getIdentity(), low, high);
    const btVector3 half = (high - low) / 2;
    hull->setMargin(static_cast<btScalar>(kMarginShare) *
                    half[half.minAxis()]);  // before the box that contains it
    hull->recalcLocalAabb();
    OwnedShape owned;
    owned.shape = std::move(hull);
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

OwnedShape makeShape(const TriangleMesh& surface, const std::vector<Box>& boxes,
                     const btTransform& body_from_asset) {
    if (boxes.empty()) return hullShape(surface, body_from_asset);
    OwnedShape owned;
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

OwnedBody makeRigidBody(const Body& solid, const std::vector<Box>& boxes, double mass_scale) {
    const PrincipalFrame frame = principalFrame(solid.moments());
    const double density = mass_scale * solid.material().density_kg_m3;
    OwnedBody owned;
    owned.shape = makeShape(solid.surface(), boxes, frame.body_from_asset);
    const btRigidBody::btRigidBodyConstructionInfo info(static_cast<btScalar>(mass_scale * solid.mass()),
                                                        nullptr, owned.shape.shape.get(),
                                                        toBullet(Vec3(density * frame.inertia)));
    owned.body = std::make_unique<btRigidBody>(info);
    return owned;
}

}  // namespace sherd
