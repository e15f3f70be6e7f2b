// What two hulls touch with, at every size, and what becomes of the app's own algorithms.

#include "bullet/shapes/piece_contacts.h"

#include <BulletCollision/CollisionDispatch/btConvexConvexAlgorithm.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>

#include <cmath>
#include <optional>
#include <random>

#include "bullet/shapes/piece_hull.h"
#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

/// A slab of `size` x `size` x a fifth of it, with the margin of a fragment's hull around it.
std::unique_ptr<PieceHull> slabHull(btScalar size) {
    auto hull = std::make_unique<PieceHull>();
    const btVector3 half(size / 2, size / 2, size / 10);
    for (int i = 0; i < 8; ++i)
        hull->addPoint(half * btVector3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1), false);
    hull->setMargin(btScalar(0.002) * size);
    hull->recalcLocalAabb();
    return hull;
}

struct Found {
    int missed = 0;
    double worst_error = 0;  // of the deepest contact, in thicknesses of a slab
};

/// One slab above the other, turned a little at random, at distances from a fiftieth of the thickness to an
/// overlap of a third of it.
Found findContacts(btScalar size, bool as_pieces) {
    const btScalar thickness = size / 5;
    std::mt19937 random(1);
    std::uniform_real_distribution<btScalar> any(-1, 1);
    Found found;
    for (int i = 0; i < 100; ++i) {
        TestWorld scene;
        std::optional<PieceContacts> contacts;
        if (as_pieces) contacts.emplace(*scene.dispatcher);
        scene.addBody(slabHull(size), 1, btVector3(0, 0, 0));
        btRigidBody* upper = scene.addBody(slabHull(size), 1, btVector3(0, 0, size));
        const btVector3 about = btVector3(any(random), any(random), 0).normalized();
        btTransform place(btQuaternion(about, btScalar(0.02) * any(random)) *
                          btQuaternion(btVector3(0, 0, 1), any(random)));
        const auto& hull = static_cast<const PieceHull&>(*upper->getCollisionShape());
        btScalar lowest = 0;
        for (int v = 0; v < hull.getNumPoints(); ++v)
            lowest = std::min(lowest, (place * hull.getScaledPoint(v)).z());
        const btScalar distance =
            thickness * (i % 3 == 0 ? btScalar(0.02) : btScalar(-0.3) * std::abs(any(random)));
        place.setOrigin(btVector3(btScalar(0.2) * size * any(random), btScalar(0.2) * size * any(random),
                                  size / 10 - lowest + 2 * hull.getMargin() + distance));
        upper->setWorldTransform(place);
        scene.world->performDiscreteCollisionDetection();
        btScalar deepest = BT_LARGE_FLOAT;
        for (int m = 0; m < scene.dispatcher->getNumManifolds(); ++m)
            for (int p = 0; p < scene.dispatcher->getManifoldByIndexInternal(m)->getNumContacts(); ++p)
                deepest = std::min(
                    deepest,
                    scene.dispatcher->getManifoldByIndexInternal(m)->getContactPoint(p).getDistance());
        if (deepest == BT_LARGE_FLOAT)
            ++found.missed;
        else
            found.worst_error = std::max(found.worst_error, double(std::abs(deepest - distance) / thickness));
    }
    return found;
}

TEST(PieceContacts, AreFoundAtEverySize) {
    for (const btScalar size : {0.1f, 0.05f, 0.02f, 0.01f, 0.005f, 0.002f}) {
        const Found found = findContacts(size, true);
        EXPECT_EQ(found.missed, 0) << size;
        EXPECT_LT(found.worst_error, 0.03) << size;
    }
    EXPECT_GT(findContacts(0.02f, false).missed, 5) << "Bullet finds them all, and this is needless";
}

TEST(PieceContacts, CrossedEdgesTouchOnce) {
    TestWorld scene;
    const PieceContacts contacts(*scene.dispatcher);
    btRigidBody* lower = scene.addBody(slabHull(0.02f), 1, btVector3(0, 0, 0));
    btRigidBody* upper = scene.addBody(slabHull(0.02f), 1, btVector3(0, 0, 0.03f));
    // Each stands on an edge of its large side.
    const btVector3 corner(0.01f, 0, 0.002f);
    const btScalar reach = corner.length(), lean = std::atan2(corner.x(), corner.z());
    lower->setWorldTransform(btTransform(btQuaternion(btVector3(0, 1, 0), -lean), btVector3(0, 0, 0)));
    upper->setWorldTransform(btTransform(
        btQuaternion(btVector3(0, 0, 1), SIMD_HALF_PI) * btQuaternion(btVector3(0, 1, 0), SIMD_PI - lean),
        btVector3(0, 0, 2 * reach)));
    scene.world->performDiscreteCollisionDetection();
    ASSERT_EQ(scene.dispatcher->getNumManifolds(), 1);
    const btPersistentManifold& manifold = *scene.dispatcher->getManifoldByIndexInternal(0);
    ASSERT_EQ(manifold.getNumContacts(), 1);
    EXPECT_NEAR(manifold.getContactPoint(0).getDistance(), -0.08e-3, 0.02e-3);
    EXPECT_LT((manifold.getContactPoint(0).m_positionWorldOnB - btVector3(0, 0, reach)).length(), 0.1e-3f);
}

/// Bullet asks first for contacts of a pair whether it is awake; a query of the app's does not.
TEST(PieceContacts, OfAPairThatSleepsAreFoundOnceItIsAwake) {
    TestWorld scene;
    const PieceContacts contacts(*scene.dispatcher);
    scene.dispatcher->setNearCallback([](btBroadphasePair& pair, btCollisionDispatcher& dispatcher,
                                         const btDispatcherInfo& info) {
        btCollisionObject *a = static_cast<btCollisionObject*>(pair.m_pProxy0->m_clientObject),
                          *b = static_cast<btCollisionObject*>(pair.m_pProxy1->m_clientObject);
        const btCollisionObjectWrapper of_a(nullptr, a->getCollisionShape(), a, a->getWorldTransform(), -1,
                                            -1),
            of_b(nullptr, b->getCollisionShape(), b, b->getWorldTransform(), -1, -1);
        if (!pair.m_algorithm)
            pair.m_algorithm = dispatcher.findAlgorithm(&of_a, &of_b, nullptr, BT_CONTACT_POINT_ALGORITHMS);
        btManifoldResult result(&of_a, &of_b);
        pair.m_algorithm->processCollision(&of_a, &of_b, info, &result);
    });
    for (const btScalar z : {0.f, 0.004f})
        scene.addBody(slabHull(0.02f), 1, btVector3(0, 0, z))->forceActivationState(ISLAND_SLEEPING);
    scene.world->performDiscreteCollisionDetection();
    EXPECT_EQ(scene.dispatcher->getNumManifolds(), 1);
}

/// Counts the pairs that come to it.
struct CountingFunction : btConvexConvexAlgorithm::CreateFunc {
    explicit CountingFunction(btConvexPenetrationDepthSolver* depth)
        : btConvexConvexAlgorithm::CreateFunc(depth) {}
    btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                   const btCollisionObjectWrapper* a,
                                                   const btCollisionObjectWrapper* b) override {
        ++pairs;
        return btConvexConvexAlgorithm::CreateFunc::CreateCollisionAlgorithm(info, a, b);
    }
    int pairs = 0;
};

/// Pairs of hulls that come to the app's own function: two pieces, and two hulls of the app's.
int pairsThatCome(TestWorld& scene, const CountingFunction& own, bool pieces, btScalar speed_m_s = 0) {
    const int before = own.pairs;
    for (int i = 0; i < 2; ++i) {
        std::unique_ptr<btConvexHullShape> hull = slabHull(0.02f);
        if (!pieces) {
            auto plain = std::make_unique<btConvexHullShape>();
            for (int v = 0; v < hull->getNumPoints(); ++v) plain->addPoint(hull->getScaledPoint(v));
            hull = std::move(plain);
        }
        scene.addBody(std::move(hull), 1, btVector3(0, 0, 0.003f * btScalar(i)))
            ->setLinearVelocity(btVector3(speed_m_s * btScalar(i), 0, 0));
    }
    scene.world->performDiscreteCollisionDetection();
    while (scene.world->getNumCollisionObjects() > 0)
        scene.world->removeCollisionObject(scene.world->getCollisionObjectArray()[0]);
    return own.pairs - before;
}

TEST(PieceContacts, LeaveOtherShapesToTheFunctionsOfTheApp) {
    TestWorld scene;
    btGjkEpaPenetrationDepthSolver depth;
    CountingFunction own(&depth);
    scene.dispatcher->registerCollisionCreateFunc(CONVEX_HULL_SHAPE_PROXYTYPE, CONVEX_HULL_SHAPE_PROXYTYPE,
                                                  &own);
    {
        auto first = std::make_unique<FractureWorld>(scene.world.get());
        EXPECT_EQ(pairsThatCome(scene, own, true), 0);
        EXPECT_EQ(pairsThatCome(scene, own, false), 1);
        const FractureWorld second(scene.world.get());
        first.reset();
        EXPECT_EQ(pairsThatCome(scene, own, true), 0) << "the second world is still there";
        EXPECT_EQ(pairsThatCome(scene, own, false), 1);
    }
    EXPECT_EQ(pairsThatCome(scene, own, true), 1) << "the function is back";
}

/// The second world finds another function than the first one has left there.
TEST(PieceContacts, OfTwoWorldsShareTheirEntries) {
    TestWorld scene;
    btGjkEpaPenetrationDepthSolver depth;
    CountingFunction own(&depth);
    auto first = std::make_unique<PieceContacts>(*scene.dispatcher);
    scene.dispatcher->registerCollisionCreateFunc(CONVEX_HULL_SHAPE_PROXYTYPE, CONVEX_HULL_SHAPE_PROXYTYPE,
                                                  &own);
    const PieceContacts second(*scene.dispatcher);
    first.reset();
    scene.addBox(0, btVector3(1, 1, 1), btVector3(0, 0, -1));
    EXPECT_EQ(pairsThatCome(scene, own, false), 1);
}

TEST(PieceContacts, OfFastPairsAreThoseOfTheFunctionOfTheApp) {
    TestWorld scene;
    btGjkEpaPenetrationDepthSolver depth;
    CountingFunction own(&depth);
    scene.dispatcher->registerCollisionCreateFunc(CONVEX_HULL_SHAPE_PROXYTYPE, CONVEX_HULL_SHAPE_PROXYTYPE,
                                                  &own);
    const PieceContacts contacts(*scene.dispatcher);
    EXPECT_EQ(pairsThatCome(scene, own, true, 0.9f), 0);
    EXPECT_EQ(pairsThatCome(scene, own, true, 1.1f), 1);
}

TEST(PieceContacts, LeaveAFunctionThatCameLater) {
    TestWorld scene;
    btGjkEpaPenetrationDepthSolver depth;
    CountingFunction own(&depth);
    {
        const PieceContacts contacts(*scene.dispatcher);
        scene.dispatcher->registerCollisionCreateFunc(CONVEX_HULL_SHAPE_PROXYTYPE,
                                                      CONVEX_HULL_SHAPE_PROXYTYPE, &own);
    }
    EXPECT_EQ(pairsThatCome(scene, own, true), 1);
}

}  // namespace
