#include "bullet/shapes/flat_face.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace sherd;

constexpr float most = 1e-5f;

/// Turned and moved.
btTransform somewhere() {
    return btTransform(btQuaternion(btVector3(1, 2, 3).normalized(), 0.7f), btVector3(3, -2, 5));
}

btConvexHullShape prism(int corners, float radius, float half_height) {
    btConvexHullShape hull;
    for (int i = 0; i < corners; ++i)
        for (const float z : {-half_height, half_height})
            hull.addPoint({radius * std::cos(SIMD_2_PI * float(i) / float(corners)),
                           radius * std::sin(SIMD_2_PI * float(i) / float(corners)), z});
    return hull;
}

/// The upper face of a shape whose z axis is up.
void expectUpperFace(const btCollisionShape& shape, float height, float thickness, float inside,
                     float outside) {
    const btTransform place = somewhere();
    // As far off as Bullet's normals of hulls are.
    const btVector3 about_up = place.getBasis() * btVector3(0.03f, -0.02f, 1).normalized();
    const auto face = faceTowards({&shape, place}, about_up);
    ASSERT_TRUE(face);
    EXPECT_LT((face->normal - place.getBasis().getColumn(2)).length(), most);
    EXPECT_NEAR(face->above(place * btVector3(0.1f, 0.2f, height + 0.25f)), 0.25f, most);
    EXPECT_NEAR(face->thickness, thickness, most);
    for (int i = 0; i < 12; ++i) {
        const btVector3 way(std::cos(0.5f * float(i)), std::sin(0.5f * float(i)), 0.3f);
        EXPECT_TRUE(face->isUnder(place * (inside * way))) << i;
        EXPECT_FALSE(face->isUnder(place * (outside * way))) << i;
    }
    const btBoxShape small(btVector3(0.1f, 0.1f, 0.1f));
    const auto isUnderBoxAt = [&](float x) {
        return face->isUnder(PlacedShape{
            &small, place * btTransform(btQuaternion::getIdentity(), btVector3(x, 0, height + 0.1f))});
    };
    EXPECT_TRUE(isUnderBoxAt(0));
    EXPECT_FALSE(isUnderBoxAt(0.95f * outside)) << "part of it is beside the face";
    EXPECT_FALSE(faceTowards({&shape, place}, place.getBasis() * btVector3(0.5f, 0, 0.86f)))
        << "an edge faces that way";
}

TEST(FlatFace, OfABox) {
    expectUpperFace(btBoxShape(btVector3(1, 1, 0.4f)), 0.4f, 0.8f, 0.98f, 1.42f);
}

TEST(FlatFace, OfACylinder) {
    expectUpperFace(btCylinderShapeZ(btVector3(1, 1, 0.4f)), 0.4f, 0.8f, 0.98f, 1.01f);
}

TEST(FlatFace, OfAHullWithItsMargin) {
    for (const int corners : {3, 4, 6, 40}) {
        btConvexHullShape hull = prism(corners, 1, 0.4f);
        hull.setMargin(0.02f);
        expectUpperFace(hull, 0.42f, 0.8f, std::cos(SIMD_PI / float(corners)) - 0.01f, 1.01f);
    }
}

/// As of a mesh all of whose vertices are given to the hull, and of one that is rounded to tenths of
/// millimetres.
TEST(FlatFace, OfAHullWithPointsWithinItsFaces) {
    btConvexHullShape hull;
    hull.setMargin(0);
    constexpr int n = 10;
    for (int i = -n; i <= n; ++i)
        for (int j = -n; j <= n; ++j)
            for (const float z : {-0.4f, 0.4f}) hull.addPoint({float(i) / n, float(j) / n, z});
    expectUpperFace(hull, 0.4f, 0.8f, 0.98f, 1.42f);
    hull.addPoint(btVector3(0.3f, 0.2f, 0.4001f));
    const auto face = faceTowards({&hull, btTransform::getIdentity()}, btVector3(0.03f, 0, 1).normalized());
    ASSERT_TRUE(face);
    EXPECT_GT(face->normal.z(), 0.99999f);
    EXPECT_TRUE(face->isUnder(btVector3(0.9f, 0.9f, 1)));
}

TEST(FlatFace, OfAHullThatIsScaled) {
    btConvexHullShape hull = prism(40, 0.5f, 0.2f);
    hull.setMargin(0);
    hull.setLocalScaling(btVector3(2, 2, 2));
    expectUpperFace(hull, 0.4f, 0.8f, 0.98f, 1.01f);
}

TEST(FlatFace, OfAPlaneHasNoEnd) {
    const btStaticPlaneShape plane(btVector3(0, 0, 1), 0.5f);
    const auto face = faceTowards({&plane, btTransform::getIdentity()}, btVector3(0, 0, 1));
    ASSERT_TRUE(face);
    EXPECT_TRUE(face->isUnder(btVector3(1e4f, -1e4f, 0)));
    EXPECT_EQ(face->height, 0.5f);
}

TEST(FlatFace, WhatIsRoundHasNone) {
    const btSphereShape ball(1);
    EXPECT_FALSE(faceTowards({&ball, somewhere()}, btVector3(0, 0, 1)));
    const btCylinderShapeZ cylinder(btVector3(1, 1, 1));
    EXPECT_FALSE(faceTowards({&cylinder, btTransform::getIdentity()}, btVector3(1, 0, 0)));
    btConvexHullShape dome;  // the facets are smaller than what Bullet's normals can tell apart
    for (int i = 0; i < 2000; ++i) {
        const float z = 1 - 2 * (float(i) + 0.5f) / 2000, angle = 2.39996f * float(i);
        dome.addPoint(
            btVector3(std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z));
    }
    const auto facet = faceTowards({&dome, btTransform::getIdentity()}, btVector3(0, 0, 1));
    const btBoxShape small(btVector3(0.1f, 0.1f, 0.1f));
    EXPECT_TRUE(!facet || !facet->isUnder(PlacedShape{&small, btTransform::getIdentity()}));
}

TEST(FlatFace, OfNothingThereIsNone) {
    EXPECT_FALSE(faceTowards({}, btVector3(0, 0, 1)));
    const btConvexHullShape empty;
    EXPECT_FALSE(faceTowards({&empty, btTransform::getIdentity()}, btVector3(0, 0, 1)));
    btConvexHullShape line;
    line.addPoint(btVector3(0, 0, 0));
    line.addPoint(btVector3(1, 0, 0));
    line.addPoint(btVector3(2, 0, 0));
    EXPECT_FALSE(faceTowards({&line, btTransform::getIdentity()}, btVector3(0, 0, 1)));
}

}  // namespace
