// Blows that a program asks for: pushes and explosions.

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

struct Momentum {
    btVector3 linear = btVector3(0, 0, 0), angular = btVector3(0, 0, 0);  // about the world's origin
};

Momentum momentumOf(const std::vector<btRigidBody*>& bodies) {
    Momentum sum;
    for (const btRigidBody* body : bodies) {
        const btVector3 linear = body->getLinearVelocity() / body->getInvMass();
        const btMatrix3x3& axes = body->getWorldTransform().getBasis();
        const btVector3 spin = axes.transpose() * body->getAngularVelocity(),
                        inverse = body->getInvInertiaDiagLocal();
        sum.linear += linear;
        sum.angular +=
            body->getCenterOfMassPosition().cross(linear) +
            axes * btVector3(spin.x() / inverse.x(), spin.y() / inverse.y(), spin.z() / inverse.z());
    }
    return sum;
}

TEST(AppliedBlow, IsReportedWhereItHitsTheSurface) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    const auto asset =
        BreakableAsset::fromMesh(shapes::box(Vec3(-0.5, -0.01, -0.5), Vec3(0.5, 0.01, 0.5)), crumbly());
    btRigidBody* pane =
        fracture.add(asset.value(), btTransform(btQuaternion::getIdentity(), {1, 2, 3})).value();
    ASSERT_TRUE(fracture.applyBlow(pane, {{1.1f, 1.9f, 3.2f}, {0, 10, 0}}));
    const auto events = fracture.takeEvents();
    ASSERT_EQ(events.size(), 1u);
    EXPECT_LT((events[0].position - Vec3(1.1, 1.99, 3.2)).norm(), 1e-5);
}

TEST(AppliedBlow, FarFromTheBodyIsRefused) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    const auto asset =
        BreakableAsset::fromMesh(shapes::box(Vec3(-0.5, -0.01, -0.5), Vec3(0.5, 0.01, 0.5)), crumbly());
    btRigidBody* pane = fracture.add(asset.value()).value();
    const Status beside = fracture.applyBlow(pane, {{3, -1, 0}, {0, 10, 0}});
    ASSERT_FALSE(beside);
    EXPECT_NE(beside.error().find("2.6"), std::string::npos) << beside.error();
    EXPECT_TRUE(fracture.takeEvents().empty());
}

// The lid of a hull is further from the wall of a bowl than half its radius.
TEST(AppliedBlow, WhereARayMeetsAHullIsNotRefused) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    Settings settings = Settings::forQuality(Quality::preview);
    settings.fracture.collision_shape = CollisionShape::hull;
    const auto bowl =
        BreakableAsset::fromMesh(shapes::bowl(0.06, 0.003, 24, 8), Material::ceramic(), settings);
    ASSERT_TRUE(bowl.ok()) << bowl.error();
    btRigidBody* body = fracture.add(bowl.value(), at(0, 0, 0)).value();
    const btVector3 from(0, 0, 1), to(0, 0, -1);
    btCollisionWorld::ClosestRayResultCallback ray(from, to);
    scene.world->rayTest(from, to, ray);
    ASSERT_TRUE(ray.hasHit());
    const Status pushed = fracture.applyBlow(body, {{ray.m_hitPointWorld, btVector3(0, 0, -0.1f)}});
    EXPECT_TRUE(pushed.ok()) << pushed.error();
}

TEST(AppliedBlow, BreaksABodyBetweenStepsAndItsFragmentsTakeTheImpulse) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    BodyOptions options(btTransform(btQuaternion(btVector3(1, 2, 3), 0.4f), btVector3(1, 2, 3)));
    options.velocity = btVector3(1, 0, 2);
    options.angular_velocity = btVector3(0.5f, 0.2f, 0);
    btRigidBody* body = fracture.add(plate(crumbly()), options).value();
    const Momentum before = momentumOf({body});
    Push push;
    push.point = options.start * btVector3(0.1f, 0.05f, 0.03f);
    push.impulse_n_s = options.start.getBasis() * btVector3(3, 0, -40);
    push.patch_radius_m = 0.02;
    ASSERT_TRUE(fracture.applyBlow(body, push).ok());
    EXPECT_FALSE(inWorld(scene, body));
    const std::vector<BlowEvent> events = fracture.takeEvents();
    ASSERT_EQ(events.size(), 1u);
    const BlowEvent& event = events.front();
    ASSERT_EQ(event.outcome, Outcome::broke) << event.message;
    EXPECT_GE(event.fragments.size(), 2u);
    for (const btRigidBody* piece : event.fragments) EXPECT_TRUE(inWorld(scene, piece));
    EXPECT_NEAR(event.impulse_n_s, std::hypot(3.0, 40.0), 1e-4);
    EXPECT_NEAR(event.velocity.z(), 2, 1e-6) << "before the blow";
    EXPECT_NEAR(event.position.x(), push.point.x(), 1e-6);
    const Momentum after = momentumOf(event.fragments);
    EXPECT_LT((after.linear - before.linear - push.impulse_n_s).length(), 1e-3);
    EXPECT_LT((after.angular - before.angular - push.point.cross(push.impulse_n_s)).length(), 1e-3);
    scene.step(10);
    EXPECT_EQ(fracture.bodies().size(), event.fragments.size());
}

TEST(AppliedBlow, FragmentsFallNoFasterThanTheWholeWould) {
    TestWorld scene;
    scene.world->setGravity(btVector3(0, 0, -9.81f));
    FractureWorld fracture(scene.world.get());
    btRigidBody* body = fracture.add(plate(crumbly()), at(0, 0, 5)).value();
    body->setActivationState(ISLAND_SLEEPING);
    ASSERT_TRUE(fracture.applyBlow(body, {btVector3(0, 0, 5.03f), btVector3(0, 0, -50)}).ok());
    const std::vector<BlowEvent> events = fracture.takeEvents();
    ASSERT_EQ(events.front().outcome, Outcome::broke);
    const btVector3 before = momentumOf(events.front().fragments).linear;
    scene.step(1, 0.01);
    const btVector3 gained = momentumOf(events.front().fragments).linear - before;
    EXPECT_NEAR(gained.z(), -9.81 * 0.01 * events.front().asset.mass(), 1e-2);
}

TEST(AppliedBlow, AWeakOneOnlyPushes) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    btRigidBody* body = fracture.add(plate(Material::plaster()), at(0, 0, 0)).value();
    body->setActivationState(ISLAND_SLEEPING);
    ASSERT_TRUE(fracture.applyBlow(body, {btVector3(0, 0, 0.03f), btVector3(0, 0, -0.01f)}).ok());
    EXPECT_TRUE(fracture.takeEvents().empty());
    EXPECT_EQ(fracture.counts().gate, 1);
    EXPECT_TRUE(body->isActive());
    EXPECT_NEAR(body->getLinearVelocity().z(), -0.01 * body->getInvMass(), 1e-8);
}

TEST(AppliedBlow, AFasterStrikerOfTheSameImpulseStrikesHarder) {
    double last = 0;
    for (const double speed : {0.0, 10.0, 100.0, 400.0}) {
        TestWorld scene;
        FractureWorld fracture(scene.world.get());
        btRigidBody* body = fracture.add(plate(crumbly()), at(0, 0, 0)).value();
        const Push push{btVector3(0, 0, 0.03f), btVector3(0, 0, -5), 0.02, speed};
        ASSERT_TRUE(fracture.applyBlow(body, push).ok());
        const std::vector<BlowEvent> events = fracture.takeEvents();
        ASSERT_FALSE(events.empty()) << "the gate took it for harmless";
        EXPECT_GT(events.back().peak_force_n, 1.5 * last) << speed;
        last = events.back().peak_force_n;
    }
}

TEST(AppliedBlow, RefusalsSayWhy) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    btRigidBody* body = fracture.add(plate(crumbly()), at(0, 0, 0)).value();
    btRigidBody* ball = scene.addBall(1, 0.1, btVector3(0, 0, 3));
    const Push good{btVector3(0, 0, 0), btVector3(0, 0, -1)};
    const auto refusal = [&](const Push& push) { return fracture.applyBlow(body, push).error(); };
    EXPECT_EQ(fracture.applyBlow(nullptr, good).error(), "there is no body to strike (nullptr)");
    EXPECT_EQ(fracture.applyBlow(ball, good).error(),
              "the body is not breakable (it broke, was removed, or was never added)");
    EXPECT_EQ(fracture.applyBlow(body, std::vector<Push>()).error(),
              "there is no push to strike the body with (an empty list)");
    EXPECT_EQ(refusal({btVector3(0, 0, 0), btVector3(0, 0, 0)}),
              "the impulse of the push is (0, 0, 0) but must be finite and not zero, in N s");
    EXPECT_EQ(refusal({btVector3(0, std::numeric_limits<btScalar>::infinity(), 0), btVector3(0, 0, 1)}),
              "the point of the push is (0, inf, 0) but must be finite, in m");
    EXPECT_EQ(
        refusal({btVector3(0, 0, 0), btVector3(0, 0, 1), -1}),
        "the patch radius of the push is -1 but must be 0 (as small as the settings allow) or positive, "
        "in m");
    EXPECT_EQ(refusal({btVector3(0, 0, 0), btVector3(0, 0, 1), 0, -2}),
              "the speed of the push is -2 but must be 0 (not known) or positive, in m/s");
    EXPECT_EQ(refusal({btVector3(0, 0, 0), btVector3(0, 0, 1), 0, 1e300}),
              "the speed of the push is 1e+300 but must be slower than light, in m/s");
    EXPECT_NE(refusal({btVector3(0, 0, 0), btVector3(0, 0, 1e20f)}).find("faster than light"),
              std::string::npos);
    EXPECT_NE(refusal({btVector3(1e20f, 0, 0), btVector3(0, 0, 1)}).find("away from the surface"),
              std::string::npos);
    scene.world->removeRigidBody(body);
    EXPECT_EQ(refusal(good), "the body is not in this world; add it with addRigidBody first");
    body->setMassProps(0, btVector3(0, 0, 0));
    scene.world->addRigidBody(body);
    EXPECT_EQ(
        refusal(good),
        "the body is static or kinematic; only bodies that move, and static ones with supports, can break");
}

/// Runs a piece of a test where Bullet calls the app: at the near callback of its first pair.
class MidStep {
  public:
    MidStep(TestWorld& scene, std::function<void()> what) : scene_(scene) {
        task() = std::move(what);
        scene_.dispatcher->setNearCallback(
            [](btBroadphasePair& pair, btCollisionDispatcher& dispatcher, const btDispatcherInfo& info) {
                if (task()) std::exchange(task(), nullptr)();
                btCollisionDispatcher::defaultNearCallback(pair, dispatcher, info);
            });
    }
    ~MidStep() { scene_.dispatcher->setNearCallback(&btCollisionDispatcher::defaultNearCallback); }

  private:
    static std::function<void()>& task() {
        static std::function<void()> kept;
        return kept;
    }
    TestWorld& scene_;
};

TEST(AppliedBlow, InsideAStepItWaitsForTheEnd) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    btRigidBody* body = fracture.add(plate(crumbly()), at(0, 0, 0)).value();
    scene.addBall(0.001, 0.1, btVector3(0, 0, 0.131f));  // for a pair
    const Push push{btVector3(0, 0, -0.03f), btVector3(0, 0, 50)};
    bool whole = false;
    const MidStep once(scene, [&] {
        EXPECT_TRUE(fracture.applyBlow(body, push).ok());
        whole = inWorld(scene, body) && body->getLinearVelocity().length() == 0;
    });
    scene.step();
    EXPECT_TRUE(whole);
    EXPECT_FALSE(inWorld(scene, body));
    const std::vector<BlowEvent> events = fracture.takeEvents();
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events.front().outcome, Outcome::broke);
    EXPECT_NEAR(momentumOf(events.front().fragments).linear.z(), 50, 0.1);
}

TEST(AppliedBlow, OnABodyThatBreaksInTheSameStepItGoesToTheNearestFragment) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    btRigidBody* body = fracture.add(plate(crumbly()), at(0, 0, 0)).value();
    btRigidBody* ball = scene.addBall(2, 0.1, btVector3(0, 0, 0.129f), btVector3(0, 0, -8));
    const Push push{btVector3(0.28f, 0.28f, 0), btVector3(30, 0, 0)};
    const MidStep once(scene, [&] { EXPECT_TRUE(fracture.applyBlow(body, push).ok()); });
    scene.step();
    const std::vector<BlowEvent> events = fracture.takeEvents();
    ASSERT_EQ(events.size(), 1u) << "fragments rest from their birth";
    ASSERT_EQ(events.front().outcome, Outcome::broke);
    ASSERT_LT(events.front().normal.z(), -0.99) << "the ball's blow comes first";
    std::vector<btRigidBody*> all = events.front().fragments;
    all.push_back(ball);
    EXPECT_NEAR(momentumOf(all).linear.x(), 30, 0.1);
    const auto fastest = std::max_element(all.begin(), all.end(), [](const auto* a, const auto* b) {
        return a->getLinearVelocity().x() < b->getLinearVelocity().x();
    });
    EXPECT_LT((*fastest)->getCenterOfMassPosition().distance(push.point), 0.25);
}

TEST(AppliedBlow, OnABodyThatBreaksInTheSameStepEachPushGoesToItsNearestFragment) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    btRigidBody* body = fracture.add(plate(crumbly()), at(0, 0, 0)).value();
    scene.addBall(2, 0.1, btVector3(0, 0, 0.129f), btVector3(0, 0, -8));
    const Push right{btVector3(0.28f, 0.28f, 0), btVector3(30, 0, 0)};
    const Push left{btVector3(-0.28f, -0.28f, 0), btVector3(-30, 0, 0)};
    const MidStep once(scene, [&] { EXPECT_TRUE(fracture.applyBlow(body, {right, left}).ok()); });
    scene.step();
    const std::vector<BlowEvent> events = fracture.takeEvents();
    ASSERT_EQ(events.size(), 1u) << "fragments rest from their birth";
    ASSERT_EQ(events.front().outcome, Outcome::broke);
    const std::vector<btRigidBody*>& pieces = events.front().fragments;
    const auto [slowest, fastest] = std::minmax_element(
        pieces.begin(), pieces.end(),
        [](const auto* a, const auto* b) { return a->getLinearVelocity().x() < b->getLinearVelocity().x(); });
    EXPECT_GT((*fastest)->getLinearVelocity().x(), 5);
    EXPECT_LT((*slowest)->getLinearVelocity().x(), -5);
    EXPECT_LT((*fastest)->getCenterOfMassPosition().distance(right.point), 0.25);
    EXPECT_LT((*slowest)->getCenterOfMassPosition().distance(left.point), 0.25);
}

TEST(AppliedBlow, OfABodyThatIsRemovedInTheSameStepNothingHappens) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    btRigidBody* body = fracture.add(plate(crumbly()), at(0, 0, 0)).value();
    scene.addBall(0.001, 0.1, btVector3(0, 0, 0.131f));
    const MidStep once(scene, [&] {
        EXPECT_TRUE(fracture.applyBlow(body, {btVector3(0, 0, 0), btVector3(0, 0, 50)}).ok());
        fracture.remove(body);
    });
    scene.step();
    EXPECT_TRUE(fracture.bodies().empty());
    EXPECT_TRUE(fracture.takeEvents().empty());
}

/// The normal part of the push on a square plate at the distance d, I / (4 pi) times the integral of
/// cos^2 / r^2, on a grid.
double pushOnPlate(double impulse_n_s, double d) {
    constexpr int n = 400;
    constexpr double half_width = 0.3, cell = 2 * half_width / n;
    double sum = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double x = -half_width + (i + 0.5) * cell, y = -half_width + (j + 0.5) * cell;
            sum += d * d / std::pow(x * x + y * y + d * d, 2) * cell * cell;
        }
    return impulse_n_s / (4 * 3.14159265358979) * sum;
}

TEST(Explosion, PushesByTheSolidAngleOfWhatFacesIt) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    btRigidBody* near = fracture.add(plate(unbreakable()), at(0, 0, 0.53f)).value();
    btRigidBody* far = fracture.add(plate(unbreakable()), at(0, 0, -1.03f)).value();
    btRigidBody* out_of_reach = fracture.add(plate(unbreakable()), at(0, 0, 2)).value();
    const Result<int> struck = explode(fracture, {btVector3(0, 0, 0), 100, 1.5});
    ASSERT_TRUE(struck.ok()) << struck.error();
    EXPECT_EQ(struck.value(), 2);
    const double near_n_s = pushOnPlate(100, 0.5), far_n_s = pushOnPlate(100, 1);
    EXPECT_NEAR(momentumOf({near}).linear.z(), near_n_s, 0.02 * near_n_s);
    EXPECT_NEAR(momentumOf({far}).linear.z(), -far_n_s, 0.02 * far_n_s);
    EXPECT_NEAR(near->getLinearVelocity().x(), 0, 1e-3);
    EXPECT_LT(near->getAngularVelocity().length(), 1e-2);
    EXPECT_EQ(out_of_reach->getLinearVelocity().length(), 0);
}

// Far away a triangle counts as a point that all of the blast comes to alike.
TEST(Explosion, FarAwayIsAsStrongAsItsSolidAngle) {
    for (const double distance_m : {2.0, 4.0, 8.0, 16.0, 32.0}) {
        TestWorld scene;
        FractureWorld fracture(scene.world.get());
        btRigidBody* body =
            fracture.add(plate(unbreakable()), at(0, 0, btScalar(-0.03 - distance_m))).value();
        const double impulse_n_s = 100 * distance_m * distance_m;
        ASSERT_TRUE(explode(fracture, {btVector3(0, 0, 0), impulse_n_s, 50}).ok());
        const double expected = pushOnPlate(impulse_n_s, distance_m);
        EXPECT_NEAR(momentumOf({body}).linear.z(), -expected, 0.005 * expected) << distance_m;
        EXPECT_LT(body->getAngularVelocity().length(), 1e-3) << distance_m;
    }
}

TEST(Explosion, OnALargeTrianglePushesAlongItsNormalAndWithAQuarterOfItAll) {
    const Vec3 half(2, 2, 0.15);
    const auto slab = BreakableAsset::fromMesh(shapes::box(-half, half), unbreakable(), coarse(0.3));
    ASSERT_TRUE(slab.ok()) << slab.error();
    for (const double height_m : {0.03, 0.003, 0.0, -1e-6, -0.05}) {  // where a ray has met it; stuck in it
        TestWorld scene;
        FractureWorld fracture(scene.world.get());
        btRigidBody* body = fracture.add(slab.value(), at(0, 0, 0)).value();
        ASSERT_TRUE(explode(fracture, {btVector3(0.3f, -0.2f, btScalar(half.z() + height_m)), 100, 10}).ok());
        const btVector3 momentum = momentumOf({body}).linear;
        EXPECT_NEAR(momentum.z(), -25, 0.5) << height_m;
        EXPECT_LT(btVector3(momentum.x(), momentum.y(), 0).length(), 0.5) << height_m;
    }
}

TEST(Explosion, OnWhatIsAllAroundItMovesNothing) {
    const Vec3 half(0.5, 0.5, 0.5);
    const auto hollow = BreakableAsset::fromMesh(
        shapes::joined(shapes::box(-half, half),
                       shapes::inverted(shapes::box(Vec3(-0.4, -0.4, -0.4), Vec3(0.4, 0.4, 0.4)))),
        unbreakable(), coarse(0.1));
    ASSERT_TRUE(hollow.ok()) << hollow.error();
    for (const btVector3& centre : {btVector3(0.1f, 0, 0), btVector3(0, 0, -0.4f),
                                    btVector3(-0.4f, -0.4f, 0.05f), btVector3(0.4f, -0.4f, -0.4f)}) {
        TestWorld scene;
        FractureWorld fracture(scene.world.get());
        btRigidBody* body = fracture.add(hollow.value(), at(0, 0, 0)).value();
        ASSERT_TRUE(explode(fracture, {centre, 100, 5}).ok());
        EXPECT_LT(momentumOf({body}).linear.length(), 0.1)
            << centre.x() << ' ' << centre.y() << ' ' << centre.z();
    }
}

/// The event of an explosion over the middle of a square plate whose mesh is turned in its own coordinates.
BlowEvent explosionOver(const Mat3& turn, int squares = 6, double distance_m = 0.2) {
    const Vec3 half(0.25, 0.25, 0.02);
    Material material = Material::ceramic();
    material.strength_scatter = 0;
    const auto asset = BreakableAsset::fromMesh(
        shapes::moved(shapes::box(-half, half, squares, squares, 1), turn), material);
    EXPECT_TRUE(asset.ok()) << asset.error();
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    const Eigen::Quaterniond back(Mat3(turn.transpose()));
    const btQuaternion level(btScalar(back.x()), btScalar(back.y()), btScalar(back.z()), btScalar(back.w()));
    EXPECT_TRUE(fracture.add(asset.value(), btTransform(level)).ok());
    EXPECT_TRUE(explode(fracture, {btVector3(0, 0, btScalar(distance_m)), 200 * distance_m / 0.2, 3}).ok());
    const auto events = fracture.takeEvents();
    return events.empty() ? noBreak() : events.front();
}

TEST(Explosion, DoesNotDependOnHowTheMeshLiesInItsCoordinates) {
    const BlowEvent level = explosionOver(Mat3::Identity());
    const Mat3 to_corner =
        Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), Vec3(1, 1, 1)).toRotationMatrix();
    for (const Mat3& turn : {to_corner, shapes::tilt()}) {
        const BlowEvent turned = explosionOver(turn);
        EXPECT_NEAR(turned.peak_force_n / level.peak_force_n, 1, 0.1);
        EXPECT_NEAR(turned.largest_stress_pa / level.largest_stress_pa, 1, 0.15);
    }
}

TEST(Explosion, DoesNotDependOnHowFineTheMeshIs) {
    for (const double distance_m : {0.2, 0.6, 1.5}) {
        const BlowEvent fine = explosionOver(Mat3::Identity(), 6, distance_m);
        const BlowEvent rough = explosionOver(Mat3::Identity(), 1, distance_m);
        ASSERT_GT(fine.peak_force_n, 0);
        EXPECT_NEAR(rough.peak_force_n / fine.peak_force_n, 1, 0.1) << distance_m;
        EXPECT_NEAR(rough.largest_stress_pa / fine.largest_stress_pa, 1, 0.15) << distance_m;
    }
}

TEST(AppliedBlow, InPartsAtOnePlaceItIsOne) {
    const auto asset = BreakableAsset::fromMesh(shapes::box(Vec3(-0.2, -0.2, 0), Vec3(0.2, 0.2, 0.02), 4, 4),
                                                Material::ceramic());
    ASSERT_TRUE(asset.ok()) << asset.error();
    const auto forceOf = [&](int parts, btScalar apart_m) {
        TestWorld scene;
        FractureWorld fracture(scene.world.get());
        btRigidBody* body = fracture.add(asset.value(), at(0, 0, 0)).value();
        std::vector<Push> pushes;
        for (int i = 0; i < parts; ++i)
            pushes.push_back(
                {btVector3(apart_m * btScalar(i), 0, 0.02f), btVector3(0, 0, btScalar(-5.0 / parts)), 0, 10});
        EXPECT_TRUE(fracture.applyBlow(body, pushes).ok());
        const auto events = fracture.takeEvents();
        return events.empty() ? 0 : events.front().peak_force_n;
    };
    const double one = forceOf(1, 0);
    EXPECT_GT(one, 0);
    EXPECT_NEAR(forceOf(8, 0) / one, 1, 1e-3);
    EXPECT_NEAR(forceOf(4, 1e-4f) / one, 1, 0.02);
}

TEST(AppliedBlow, EachOfARowBreaksItsBodyAsTheFirstDid) {
    const auto asset =
        BreakableAsset::fromMesh(shapes::box(Vec3(-0.2, -0.2, 0), Vec3(0.2, 0.2, 0.02), 4, 4), crumbly());
    ASSERT_TRUE(asset.ok()) << asset.error();
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    Budget budget;
    budget.fragments_per_step = 20;
    budget.fragments_alive = 1000;
    ASSERT_TRUE(fracture.setBudget(budget).ok());
    std::vector<std::size_t> pieces;
    for (int i = 0; i < 5; ++i) {
        BodyOptions options;
        options.start = at(btScalar(i), 0, 0);
        options.seed = 1;
        btRigidBody* body = fracture.add(asset.value(), options).value();
        ASSERT_TRUE(fracture.applyBlow(body, {btVector3(btScalar(i), 0, 0.02f), btVector3(0, 0, -20)}).ok());
        for (const BlowEvent& event : fracture.takeEvents()) pieces.push_back(event.fragments.size());
    }
    ASSERT_EQ(pieces.size(), 5u);
    EXPECT_GT(pieces[0], 10u);
    for (const std::size_t count : pieces) EXPECT_EQ(count, pieces[0]);
}

TEST(Explosion, BreaksAHollowBodyFromWithin) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    const auto trough =
        BreakableAsset::fromMesh(shapes::uShape(0.05, 0.2, 0.3, 0.2), crumbly(), coarse(0.025));
    ASSERT_TRUE(trough.ok()) << trough.error();
    btRigidBody* body = fracture.add(trough.value()).value();
    const btVector3 middle = body->getCenterOfMassPosition();
    ASSERT_TRUE(explode(fracture, {middle, 200, 1}).ok());
    const std::vector<BlowEvent> events = fracture.takeEvents();
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events.front().outcome, Outcome::broke) << events.front().message;
    // Only what the opening lets out.
    EXPECT_LT(momentumOf(events.front().fragments).linear.length(), 100);
}

double massOf(const FractureWorld& fracture) {
    double sum = 0;
    for (const btRigidBody* body : fracture.bodies()) sum += 1 / double(body->getInvMass());
    return sum;
}

/// Breaks of a second explosion, among the pieces of a first one: in the call, and in the half second after.
struct SecondExplosion {
    explicit SecondExplosion(const Budget& budget) {
        TestWorld scene;
        FractureWorld fracture(scene.world.get());
        EXPECT_TRUE(fracture.setBudget(budget).ok());
        Settings settings = coarse(0.1);
        settings.fracture.smallest_fragment_m3 = 0;
        const auto slab =
            BreakableAsset::fromMesh(shapes::slab(Vec3(0.6, 0.6, 0.06), 4, 4, 1), crumbly(), settings);
        EXPECT_TRUE(fracture.add(slab.value(), at(0, 0, 0)).ok());
        const Explosion explosion{btVector3(0, 0, 0.3f), 200, 3};
        EXPECT_EQ(explode(fracture, explosion).value(), 1);
        EXPECT_EQ(fracture.takeEvents().size(), 1u);
        const double mass = massOf(fracture);
        const Result<int> second = explode(fracture, {explosion.centre, 1000, 3});
        if (!second) ADD_FAILURE() << second.error();
        struck = second.value();
        for (const BlowEvent& event : fracture.takeEvents()) in_call += event.outcome == Outcome::broke;
        for (int step = 0; step < 60; ++step) {
            scene.step();
            for (const BlowEvent& event : fracture.takeEvents()) {
                if (event.outcome != Outcome::broke) continue;
                ++later;
                EXPECT_GE(event.waited_s, budget.shortest_wait_s - 1e-9);
            }
        }
        EXPECT_NEAR(massOf(fracture), mass, 1e-6 * mass);
    }
    int struck = 0, in_call = 0, later = 0;
};

TEST(Explosion, LetsBlowsOnFragmentsWaitForTheirTurn) {
    const SecondExplosion at_once(Budget::none()), in_turn{Budget()};
    EXPECT_GT(in_turn.struck, 2);
    EXPECT_EQ(in_turn.struck, at_once.struck);
    EXPECT_GT(at_once.in_call, 0);
    EXPECT_EQ(at_once.later, 0);
    EXPECT_EQ(in_turn.in_call, 0);
    EXPECT_GT(in_turn.later, 0);
}

/// An explosion over the middle of a spiral of plates: what breaks in the call, and when the others do.
struct Plates {
    Plates(int count, const Budget& budget) {
        TestWorld scene;
        scene.world->setGravity(btVector3(0, 0, 0));
        FractureWorld fracture(scene.world.get());
        EXPECT_TRUE(fracture.setBudget(budget).ok());
        const auto asset = plate(crumbly(), 0.1);
        for (int i = 0; i < count; ++i) {
            const btScalar away_m = 1 + 0.05f * i, angle = SIMD_2_PI * i / count;
            EXPECT_TRUE(fracture.add(asset, at(away_m * btCos(angle), away_m * btSin(angle), 0)).ok());
        }
        const double mass = massOf(fracture);
        EXPECT_EQ(explode(fracture, {btVector3(0, 0, 0.6f), 5000, 3}).value(), count);
        const btVector3 momentum = momentumOf(fracture.bodies()).linear;
        take(fracture);
        in_call = waited_s.size();
        const int steps = static_cast<int>((budget.longest_wait_s + 0.01) * 240);
        for (int step = 0; step < steps; ++step) {
            scene.step();
            take(fracture);
        }
        bodies = fracture.bodies().size();
        EXPECT_NEAR(massOf(fracture), mass, 1e-6 * mass);
        EXPECT_LT((momentumOf(fracture.bodies()).linear - momentum).length(), 1e-4f * momentum.length());
    }
    void take(FractureWorld& fracture) {
        for (const BlowEvent& event : fracture.takeEvents()) {
            if (event.generation > 0) continue;
            if (event.outcome != Outcome::broke) {
                EXPECT_EQ(event.outcome, Outcome::dropped) << event.message;
                ++dropped;
                continue;
            }
            waited_s.push_back(event.waited_s);
            away_m.push_back(event.asset_transform.getOrigin().length());
        }
    }
    std::size_t in_call = 0, dropped = 0, bodies = 0;
    std::vector<double> waited_s, away_m;  // of the plates, in the order in which they broke
};

TEST(Explosion, BreaksACrowdInTurnTheNearestFirst) {
    constexpr int count = 8;
    Budget budget;
    budget.milliseconds_per_step = 0.5;
    const Plates crowd(count, budget);
    EXPECT_EQ(crowd.in_call, 1u);
    ASSERT_EQ(crowd.waited_s.size(), std::size_t(count)) << "none is dropped";
    EXPECT_EQ(crowd.dropped, 0u);
    EXPECT_TRUE(std::is_sorted(crowd.waited_s.begin(), crowd.waited_s.end()));
    EXPECT_GT(crowd.waited_s.back(), crowd.waited_s.front());
    EXPECT_LT(crowd.away_m.front(), crowd.away_m.back());
    EXPECT_LE(crowd.waited_s.back(), budget.longest_wait_s + 1e-6);

    EXPECT_EQ(Plates(count, Budget::none()).in_call, std::size_t(count));
    EXPECT_EQ(Plates(3, budget).in_call, 3u) << "as many as a step may solve";
}

// Blows that waited are answered at the end of a step, after what the app asked for inside it was carried
// out.
TEST(Explosion, EventsOfBlowsThatWaitedLeaveOutWhatACallbackRemoved) {
    TestWorld scene;
    scene.world->setGravity(btVector3(0, 0, 0));
    FractureWorld fracture(scene.world.get());
    Budget budget;
    budget.milliseconds_per_step = 0.5;
    ASSERT_TRUE(fracture.setBudget(budget).ok());
    int removed = 0;
    fracture.onFragment([&](FragmentBirth& birth) {
        if (birth.asset.mass() > 2) return;
        fracture.remove(&birth.body);
        ++removed;
    });
    const auto asset = plate(crumbly(), 0.1);
    for (int i = 0; i < 5; ++i) ASSERT_TRUE(fracture.add(asset, at(0.8f * btScalar(i - 2), 0, 0)).ok());
    ASSERT_EQ(explode(fracture, {btVector3(0, 0, 0.6f), 5000, 3}).value(), 5);
    int waited = 0;
    for (int step = 0; step < 130; ++step) {
        const int before = removed;
        scene.step();
        const auto bodies = fracture.bodies();
        for (const BlowEvent& event : fracture.takeEvents()) {
            if (event.waited_s > 0 && removed > before) ++waited;
            for (const btRigidBody* fragment : event.fragments)
                EXPECT_NE(std::find(bodies.begin(), bodies.end(), fragment), bodies.end()) << step;
        }
    }
    EXPECT_GT(waited, 1) << "of these, some fragments were removed";
}

// They could not all be done in time as the budget has it, and are all done nevertheless.
TEST(Explosion, DropsNoWholeBodyForWantOfTime) {
    constexpr int count = 6;
    Budget budget;
    budget.milliseconds_per_step = 0.001;
    const Plates crowd(count, budget);
    ASSERT_EQ(crowd.waited_s.size(), std::size_t(count));
    EXPECT_LE(crowd.waited_s.back(), budget.longest_wait_s + 1e-6);
    EXPECT_EQ(crowd.in_call, 1u);
    for (std::size_t i = 1; i < count; ++i)
        EXPECT_GT(crowd.waited_s[i], crowd.waited_s[i - 1]) << "spread over the time that there is";
}

TEST(Explosion, ACrowdSharesTheRoomForFragments) {
    constexpr int count = 8;
    Budget budget;
    budget.milliseconds_per_step = 0.5;
    budget.fragments_alive = 24;
    const Plates all(count, budget);
    EXPECT_EQ(all.waited_s.size(), std::size_t(count));
    budget.fragments_alive = 9;
    const Plates some(count, budget);
    EXPECT_EQ(some.waited_s.size(), 4u) << "into two pieces each";
    EXPECT_EQ(some.dropped, 4u);
    EXPECT_EQ(some.bodies, 12u);
}

TEST(Explosion, FollowsAnotherInTheSameStep) {
    TestWorld scene;
    scene.addFloor();
    FractureWorld fracture(scene.world.get());
    for (const btScalar x : {-0.8f, 0.8f})
        ASSERT_TRUE(fracture.add(plate(crumbly(), 0.1), at(x, 0, 0.03f)).ok());
    const Explosion explosion{btVector3(0, 0, 0.3f), 300, 3};
    const MidStep twice(scene, [&] {
        for (int i = 0; i < 2; ++i) EXPECT_EQ(explode(fracture, explosion).value(), 2);
    });
    scene.step();
    const std::vector<BlowEvent> events = fracture.takeEvents();
    EXPECT_EQ(events.size(), 2u);
    std::size_t pieces = 0;
    for (const BlowEvent& event : events) pieces += event.fragments.size();
    EXPECT_EQ(fracture.bodies().size(), pieces);
}

TEST(Explosion, LeavesAloneWhatACallbackTakesOut) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    btRigidBody* bodies[2];
    for (const int i : {0, 1})
        bodies[i] = fracture.add(plate(crumbly(), 0.1), at(i == 0 ? -0.8f : 0.8f, 0, 0)).value();
    fracture.onFragment([&](FragmentBirth&) {
        if (inWorld(scene, bodies[1])) scene.world->removeRigidBody(bodies[1]);
    });
    EXPECT_EQ(explode(fracture, {btVector3(0, 0, 0.3f), 300, 3}).value(), 2);
    const std::vector<BlowEvent> events = fracture.takeEvents();
    ASSERT_EQ(events.size(), 2u);
    EXPECT_EQ(events[0].outcome, Outcome::broke);
    EXPECT_EQ(events[1].outcome, Outcome::failed);
    EXPECT_EQ(scene.world->getNumCollisionObjects(), static_cast<int>(events[0].fragments.size()));
}

TEST(Explosion, RefusalsSayWhatIsOutOfRange) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    EXPECT_EQ(explode(fracture, {btVector3(0, 0, 0), 0, 1}).error(),
              "the impulse of the explosion is 0 but must be positive and finite, in N s");
    EXPECT_EQ(explode(fracture, {btVector3(0, 0, 0), 1, -1}).error(),
              "the reach of the explosion is -1 but must be positive and finite, in m");
    EXPECT_EQ(explode(fracture, {btVector3(std::numeric_limits<btScalar>::quiet_NaN(), 0, 0), 1, 1}).error(),
              "the centre of the explosion is not finite; give it in m");
    EXPECT_EQ(explode(fracture, {btVector3(0, 0, 0), 1, 1}).value(), 0);
}

TEST(Explode, SaysThatNothingCanTakeIt) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    btRigidBody* body = fracture.add(plate(crumbly()), at(0, 0, 0)).value();
    for (const double impulse : {1e30, 1e300})
        EXPECT_FALSE(explode(fracture, Explosion{btVector3(0, 0, 0.4f), impulse, 3}).ok()) << impulse;
    EXPECT_TRUE(inWorld(scene, body));
    EXPECT_EQ(body->getLinearVelocity().length(), 0);
}

TEST(Explode, OutlivesACallbackThatDestroysTheFractureWorld) {
    TestWorld scene;
    auto fracture = std::make_unique<FractureWorld>(scene.world.get());
    const BreakableAsset asset = plate(crumbly(), 0.1);
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(fracture->add(asset, at(0.8f * btScalar(i), 0, 0)).ok());
    fracture->onFragment([&](FragmentBirth&) { fracture.reset(); });
    const Result<int> struck = explode(*fracture, Explosion{btVector3(0.8f, 0, 0.4f), 300, 3});
    ASSERT_TRUE(struck.ok()) << struck.error();
    EXPECT_EQ(struck.value(), 3);
    EXPECT_EQ(scene.world->getNumCollisionObjects(), 0);
    EXPECT_EQ(scene.world->getConstraintSolver(), scene.solver.get());
}

/// All others are out of the world then, and nothing limits how many there may be.
TEST(AppliedBlow, TheOnlyFragmentThatCameBackBreaksAsAnyOther) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    ASSERT_TRUE(fracture.setBudget(Budget::none()).ok());
    Settings settings = coarse(0.05);
    settings.fracture.smallest_fragment_m3 = 1e-6;
    settings.fracture.fragment_count = 6;
    const auto asset = BreakableAsset::fromMesh(shapes::box(Vec3(-0.3, -0.3, -0.03), Vec3(0.3, 0.3, 0.03)),
                                                crumbly(), settings);
    btRigidBody* body = fracture.add(asset.value(), at(0, 0, 0)).value();
    const auto strike = [&](btRigidBody* struck) {
        EXPECT_TRUE(fracture.applyBlow(struck, {struck->getCenterOfMassPosition(), {0, 0, -50}}));
        const auto events = fracture.takeEvents();
        EXPECT_EQ(events.size(), 1u);
        return events.empty() ? std::vector<btRigidBody*>() : events.front().fragments;
    };
    const auto fragments = strike(body);
    ASSERT_GT(fragments.size(), 2u);
    btRigidBody* heaviest =
        *std::min_element(fragments.begin(), fragments.end(),
                          [](const auto* a, const auto* b) { return a->getInvMass() < b->getInvMass(); });
    scene.step(60);  // no longer just born
    fracture.takeEvents();
    for (btRigidBody* fragment : fragments) scene.world->removeRigidBody(fragment);
    scene.addBall(1, 0.05, {9, 9, 9}, {1, 0, 0});  // a world asleep does not look who is there
    scene.step(1);
    scene.world->addRigidBody(heaviest);
    EXPECT_GT(strike(heaviest).size(), 2u);
}

}  // namespace
