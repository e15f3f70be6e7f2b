#include "bullet/shapes/missed_vertices.h"

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

/// Lowest points that the first manifold has, or that it lacks and that are found; those within 1 mm once.
std::vector<btVector3> lowestPoints(const TestWorld& scene, const btRigidBody* body, bool with_missed) {
    std::vector<btVector3> points;
    const auto add = [&](const btManifoldPoint& point, bool is_a) {
        const btVector3 place = is_a ? point.getPositionWorldOnA() : point.getPositionWorldOnB();
        for (const btVector3& known : points)
            if (known.distance(place) < 1e-3) return;
        points.push_back(place);
    };
    const btDispatcher& dispatcher = *scene.dispatcher;
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        const btPersistentManifold& manifold =
            *const_cast<btDispatcher&>(dispatcher).getManifoldByIndexInternal(i);
        const bool is_a = manifold.getBody0() == body;
        for (int k = 0; k < manifold.getNumContacts(); ++k) add(manifold.getContactPoint(k), is_a);
        if (!with_missed) continue;
        for (const btManifoldPoint& point : missedVertices(manifold, manifold.getBody0()->getWorldTransform(),
                                                           manifold.getBody1()->getWorldTransform(), {})) {
            EXPECT_LT(point.getDistance(), 0);
            EXPECT_EQ(point.getAppliedImpulse(), 0);
            add(point, is_a);
        }
    }
    return points;
}

std::unique_ptr<btConvexHullShape> cubeHull() {
    auto hull = std::make_unique<btConvexHullShape>();
    for (int corner = 0; corner < 8; ++corner)
        hull->addPoint(
            btVector3(corner & 1 ? 0.1f : -0.1f, corner & 2 ? 0.1f : -0.1f, corner & 4 ? 0.1f : -0.1f));
    hull->setMargin(0.001f);
    return hull;
}

TEST(MissedVertices, OfAHullThatLandsFlatAreItsCorners) {
    TestWorld scene;
    scene.addFloor();
    btRigidBody* body = scene.addBody(cubeHull(), 4, btVector3(0, 0, 0.095f));
    scene.world->performDiscreteCollisionDetection();
    EXPECT_LT(lowestPoints(scene, body, false).size(), 4u) << "Bullet has them all by itself now";
    int corners = 0;
    for (const btVector3& point : lowestPoints(scene, body, true))
        corners += std::abs(point.x()) > 0.099f && std::abs(point.y()) > 0.099f;
    EXPECT_EQ(corners, 4);
}

TEST(MissedVertices, TellWhetherAPointIsBetweenThem) {
    const auto point = [](btScalar x, btScalar y, btScalar distance) {
        return btManifoldPoint(btVector3(x, y, 0), btVector3(x, y, 0), btVector3(0, 0, 1), distance);
    };
    btManifoldPoint middle = point(0.02f, 0, -0.001f);
    middle.m_positionWorldOnA = btVector3(0.02f, 0, 0);
    const auto corners = [&](btScalar depth, int count) {
        std::vector<btManifoldPoint> all;
        for (int i = 0; i < count; ++i) {
            all.push_back(point(0, 0, -depth));
            all.back().m_positionWorldOnA = btVector3(i & 1 ? 0.1f : -0.1f, i & 2 ? 0.1f : -0.1f, 0);
        }
        return all;
    };
    EXPECT_TRUE(isBetween(middle, corners(0.001f, 4)));
    EXPECT_TRUE(isBetween(middle, corners(0.002f, 4)));
    EXPECT_FALSE(isBetween(middle, corners(-0.01f, 4))) << "the middle sticks out";
    EXPECT_FALSE(isBetween(middle, corners(0.001f, 2))) << "on one side of it";
    EXPECT_FALSE(isBetween(middle, {}));
}

TEST(MissedVertices, AllOnOneSideOfAPointDoNotHaveItBetweenThemHoweverTheyAreTurned) {
    const btVector3 normal = btVector3(0.3f, 0.2f, 0.93f).normalized();
    btVector3 a, b;
    btPlaneSpace1(normal, a, b);
    const auto at = [&](btScalar degrees) {
        const btVector3 place =
            a * btCos(degrees * SIMD_RADS_PER_DEG) + b * btSin(degrees * SIMD_RADS_PER_DEG);
        btManifoldPoint point(place, place, normal, 0);
        point.m_positionWorldOnA = place;
        return point;
    };
    btManifoldPoint middle(btVector3(0, 0, 0), btVector3(0, 0, 0), normal, 0);
    middle.m_positionWorldOnA.setZero();
    for (int turn = 0; turn < 360; ++turn) {
        const auto t = btScalar(turn);
        EXPECT_FALSE(isBetween(middle, {at(t), at(t + 30), at(t + 60), at(t + 90)})) << turn;
        EXPECT_FALSE(isBetween(middle, {at(t), at(t + 180), at(t + 180), at(t)})) << turn;
        EXPECT_TRUE(isBetween(middle, {at(t), at(t + 180)}, true)) << turn << ": on an edge";
        EXPECT_FALSE(isBetween(middle, {at(t), at(t + 170)}, true)) << turn;
        EXPECT_TRUE(isBetween(middle, {at(t), at(t + 100), at(t + 200), at(t + 300)})) << turn;
    }
}

TEST(MissedVertices, OfABoxOnAPlaneAreItsCorners) {
    TestWorld scene;
    scene.addBody(std::make_unique<btStaticPlaneShape>(btVector3(0, 0, 1), btScalar(0)), 0,
                  btVector3(0, 0, 0));
    btRigidBody* body = scene.addBox(4, btVector3(0.1f, 0.1f, 0.1f), btVector3(0, 0, 0.095f));
    scene.world->performDiscreteCollisionDetection();
    EXPECT_EQ(lowestPoints(scene, body, true).size(), 4u);
}

TEST(MissedVertices, OfAHullOnAThinPaneAreItsCorners) {
    for (const btScalar thickness : {btScalar(0.004), btScalar(0.2)}) {
        TestWorld scene;
        scene.addBox(0, btVector3(1, 1, thickness / 2), btVector3(0, 0, -thickness / 2));
        auto hull = std::make_unique<btConvexHullShape>();
        for (int corner = 0; corner < 8; ++corner)
            hull->addPoint(
                btVector3(corner & 1 ? 0.4f : -0.4f, corner & 2 ? 0.4f : -0.4f, corner & 4 ? 0.05f : -0.05f));
        hull->setMargin(0.001f);
        scene.addBody(std::move(hull), 4, btVector3(0, 0, 0.0505f));
        scene.world->performDiscreteCollisionDetection();
        btDispatcher& dispatcher = *scene.world->getDispatcher();
        ASSERT_EQ(dispatcher.getNumManifolds(), 1);
        const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(0);
        ASSERT_GT(manifold.getNumContacts(), 0);
        const auto vertices = missedVertices(manifold, manifold.getBody0()->getWorldTransform(),
                                             manifold.getBody1()->getWorldTransform(),
                                             {manifold.getContactBreakingThreshold()});
        EXPECT_GE(vertices.size(), 3u) << thickness;
    }
}

// The threshold grows with the body, so that corners of its small parts become one.
TEST(MissedVertices, OfASmallPartOfALargeBodyAreKeptApart) {
    TestWorld scene;
    scene.addFloor();
    btBoxShape part(btVector3(0.02f, 0.002f, 0.002f));
    btBoxShape far_away(btVector3(0.01f, 0.01f, 0.01f));
    auto shape = std::make_unique<btCompoundShape>();
    shape->addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, 0)), &part);
    shape->addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, 1)), &far_away);
    btRigidBody* body = scene.addBody(std::move(shape), 1, btVector3(0, 0, 0.001f));
    scene.world->performDiscreteCollisionDetection();
    EXPECT_LT(lowestPoints(scene, body, false).size(), 4u) << "Bullet has them all by itself now";
    EXPECT_EQ(lowestPoints(scene, body, true).size(), 4u);
}

TEST(MissedVertices, AreNoneBesideTheOtherBody) {
    TestWorld scene;
    scene.addBox(0, btVector3(0.05f, 5, 0.5f), btVector3(0, 0, -0.5f));
    btRigidBody* body = scene.addBody(cubeHull(), 4, btVector3(0, 0, 0.095f));
    scene.world->performDiscreteCollisionDetection();
    const auto points = lowestPoints(scene, body, true);
    ASSERT_FALSE(points.empty());
    for (const btVector3& point : points) EXPECT_LT(std::abs(point.x()), 0.06);
}

}  // namespace
