#include "bullet/shapes/shapes.h"

#include <BulletCollision/CollisionShapes/btUniformScalingShape.h>

#include <algorithm>

#include "bullet/shapes/rigid_body_factory.h"
#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

struct Extent {
    Vec3 low = Vec3::Constant(1e9), high = Vec3::Constant(-1e9);
};

Extent extentOf(const std::vector<Vec3>& points) {
    Extent extent;
    for (const Vec3& p : points) {
        extent.low = extent.low.cwiseMin(p);
        extent.high = extent.high.cwiseMax(p);
    }
    return extent;
}

TEST(ConvexParts, BoxGivesItsEightCorners) {
    const auto parts = convexParts(btBoxShape(btVector3(1, 2, 3)));
    ASSERT_TRUE(parts.ok());
    ASSERT_EQ(parts.value().size(), 1u);
    EXPECT_EQ(parts.value()[0].size(), 8u);
    const Extent extent = extentOf(parts.value()[0]);
    EXPECT_LT((extent.high - Vec3(1, 2, 3)).norm(), 1e-6);
    EXPECT_LT((extent.low + Vec3(1, 2, 3)).norm(), 1e-6);
}

TEST(ConvexParts, CompoundsOfCompoundsAreFlattenedWithTheirFrames) {
    btBoxShape box(btVector3(1, 1, 1));
    btCompoundShape inner, outer;
    inner.addChildShape(at(10, 0, 0), &box);
    outer.addChildShape(btTransform(btQuaternion(btVector3(0, 0, 1), SIMD_HALF_PI), btVector3(0, 0, 5)),
                        &inner);
    outer.addChildShape(at(0, 0, 0), &box);
    const auto parts = convexParts(outer);
    ASSERT_TRUE(parts.ok());
    ASSERT_EQ(parts.value().size(), 2u);
    const Extent extent = extentOf(parts.value()[0]);
    EXPECT_LT(((extent.low + extent.high) / 2 - Vec3(0, 10, 5)).norm(), 1e-5);
}

TEST(ConvexParts, RoundShapesGetPointsOnTheirSurface) {
    const auto parts = convexParts(btSphereShape(2));
    ASSERT_TRUE(parts.ok());
    EXPECT_GT(parts.value()[0].size(), 30u);
    for (const Vec3& p : parts.value()[0]) EXPECT_NEAR(p.norm(), 2, 1e-4);
}

TEST(StrikingRadius, IsThatOfRoundShapesAndNothingElse) {
    btSphereShape sphere(0.3f);
    btBoxShape box(btVector3(1, 1, 1));
    EXPECT_FLOAT_EQ(strikingRadius(sphere, -1), 0.3f);
    EXPECT_FLOAT_EQ(strikingRadius(btCapsuleShape(0.2f, 1), -1), 0.2f);
    EXPECT_FLOAT_EQ(strikingRadius(btCylinderShape(btVector3(0.4f, 1, 0.4f)), -1), 0.4f);
    EXPECT_EQ(strikingRadius(box, -1), 0);
    btConvexHullShape hull;
    EXPECT_EQ(strikingRadius(hull, -1), 0);
    btSphereShape unit(1);
    EXPECT_FLOAT_EQ(strikingRadius(btUniformScalingShape(&unit, 0.25f), -1), 0.25f);
    btCompoundShape compound;
    compound.addChildShape(at(0, 0, 0), &box);
    compound.addChildShape(at(3, 0, 0), &sphere);
    EXPECT_EQ(strikingRadius(compound, 0), 0);
    EXPECT_FLOAT_EQ(strikingRadius(compound, 1), 0.3f);
    EXPECT_EQ(strikingRadius(compound, -1), 0) << "predicted contacts name no child";
    EXPECT_EQ(strikingRadius(compound, 7), 0);
}

TEST(MakeShape, WithoutBoxesTheHullOfTheSurfaceStandsIn) {
    const auto ball = BreakableAsset::fromMesh(shapes::icosphere(0.05, 3), unbreakable());
    const OwnedShape owned =
        makeShape(*ball.value().solid(), CollisionShape::boxes, {}, btTransform::getIdentity());
    btVector3 low, high;
    owned.shape->getAabb(btTransform::getIdentity(), low, high);
    EXPECT_NEAR(high.x(), 0.05, 0.003) << "Bullet's own margin of 4 cm would nearly double it";
    EXPECT_TRUE(owned.shape->isConvex());
}

}  // namespace
