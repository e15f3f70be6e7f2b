// The break as part of the collision: momentum, the step taken again, and what fragments take over.

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

constexpr auto broke = Outcome::broke;

struct Momentum {
    Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();  // about the world's origin
    double scale = 0;                                    // sum of the magnitudes of the linear ones
};

Vec3 vec(const btVector3& v) {
    return Vec3(v.x(), v.y(), v.z());
}

Momentum momentumOf(const std::vector<btRigidBody*>& bodies) {
    Momentum sum;
    for (const btRigidBody* body : bodies) {
        const double mass = 1.0 / body->getInvMass();
        const Vec3 p = mass * vec(body->getLinearVelocity());
        const btMatrix3x3 inertia = body->getInvInertiaTensorWorld().inverse();
        sum.linear += p;
        sum.angular +=
            vec(body->getCenterOfMassPosition()).cross(p) + vec(inertia * body->getAngularVelocity());
        sum.scale += p.norm();
    }
    return sum;
}

TEST(Break, PlateIsSwappedForItsFragmentsInsideTheStep) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    btRigidBody* body = fracture.add(plate(crumbly()), at(0, 0, 0)).value();
    scene.addBall(2, 0.1, btVector3(0.05, 0.02, 0.2), btVector3(0, 0, -8));
    const BlowEvent event = stepUntilBreak(scene, fracture);
    ASSERT_EQ(event.outcome, broke) << event.message;
    EXPECT_EQ(event.body, body);
    EXPECT_GE(event.fragments.size(), 2u);
    EXPECT_FALSE(inWorld(scene, body));
    EXPECT_EQ(fracture.bodies(), event.fragments);
    for (const btRigidBody* fragment : event.fragments) EXPECT_TRUE(inWorld(scene, fragment));
    EXPECT_NEAR(event.position.x(), 0.05, 0.01);
    EXPECT_NEAR(event.position.y(), 0.02, 0.01);
    EXPECT_NEAR(event.position.z(), 0.03, 0.01);
    EXPECT_LT(event.normal.z(), -0.99);
    EXPECT_GE(fracture.counts().solved(), 1);
}

TEST(Break, FragmentsCarryTheMomentumOfTheWhole) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    btRigidBody* body =
        fracture
            .add(plate(crumbly()), btTransform(btQuaternion(btVector3(1, 2, 3), 0.4f), btVector3(1, 2, 3)))
            .value();
    body->setLinearVelocity(btVector3(1, -2, 0.5));
    body->setAngularVelocity(btVector3(3, 1, -2));
    scene.addBall(2, 0.1, btVector3(1, 2, 3.2f), btVector3(1, -2, -8));
    const BlowEvent event = stepUntilBreak(scene, fracture);
    ASSERT_EQ(event.outcome, broke) << event.message;
    EXPECT_LT(event.momentum_error_rel, 1e-5);
}

TEST(Break, BallAndPlateTogetherKeepTheirMomentum) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    btRigidBody* body = fracture.add(plate(crumbly()), at(0, 0, 0)).value();
    body->setDamping(0, 0);
    body->setAngularVelocity(btVector3(0.5, -1, 2));
    btRigidBody* ball = scene.addBall(2, 0.1, btVector3(0.1, 0, 0.3), btVector3(0, 0, -8));
    const Momentum before = momentumOf({body, ball});
    const BlowEvent event = stepUntilBreak(scene, fracture);
    ASSERT_EQ(event.outcome, broke) << event.message;
    std::vector<btRigidBody*> after = event.fragments;
    after.push_back(ball);
    const Momentum now = momentumOf(after);
    EXPECT_LT((now.linear - before.linear).norm(), 1e-5 * before.scale);
    // Bullet integrates the free turning of the plate to first order until the ball arrives, and lets
    // friction act at two points a little apart; the break itself adds nothing to that.
    EXPECT_LT((now.angular - before.angular).norm(), 5e-3 * before.scale);
}

TEST(Break, BallGoesOnThroughTheBrokenPane) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    ASSERT_TRUE(fracture.add(plate(crumbly()), at(0, 0, 0)).ok());
    btRigidBody* ball = scene.addBall(20, 0.1, btVector3(0, 0, 0.3), btVector3(0, 0, -20));
    const BlowEvent event = stepUntilBreak(scene, fracture);
    ASSERT_EQ(event.outcome, broke) << event.message;
    EXPECT_LT(ball->getLinearVelocity().z(), -12) << "the solve with the whole plate was kept";
    scene.step(48);
    EXPECT_LT(ball->getLinearVelocity().z(), -12);
    EXPECT_LT(ball->getWorldTransform().getOrigin().z(), -0.2);
}

// At 60 steps a second a fast ball is first seen where it overlaps deeply. Some of its contacts are across
// its way there: how deep they are over how fast they close says nothing of when they were met.
// At 60 steps a second the ball is up to 15 cm deep in the brick before Bullet knows.
TEST(Break, PiecesArePushedByWhatAStepTakesDeepIntoTheWhole) {
    Settings settings = Settings::forQuality(Quality::preview);
    settings.fracture.largest_generation = 1;
    const auto brick = BreakableAsset::fromMesh(
        shapes::box(Vec3(-0.125, -0.06, -0.05), Vec3(0.125, 0.06, 0.05)), Material::brick(), settings);
    ASSERT_TRUE(brick.ok()) << brick.error();
    constexpr int phases = 12;
    int breaks = 0;
    for (int phase = 0; phase < phases; ++phase) {
        TestWorld scene;
        FractureWorld fracture(scene.world.get());
        ASSERT_TRUE(fracture.add(brick.value(), at(0, 0, 0)).ok());
        const btVector3 way = btVector3(0.05f, -0.94f, 0.32f).normalized();
        const btScalar speed = 9, back = 0.3f + speed / 60 * btScalar(phase) / phases;
        scene.addBall(4, 0.05, -back * way, speed * way);
        const BlowEvent event = stepUntilBreak(scene, fracture, 10, 1.0 / 60);
        if (event.outcome != Outcome::broke) continue;  // it went through in a step, or grazed it
        ++breaks;
        btVector3 momentum(0, 0, 0);
        for (const btRigidBody* body : fracture.bodies())
            momentum += body->getLinearVelocity() / body->getInvMass();
        EXPECT_GT(Vec3(momentum.x(), momentum.y(), momentum.z()).dot(event.normal), 0.4 * event.impulse_n_s)
            << phase;
    }
    EXPECT_GT(breaks, phases / 2);
}

TEST(Break, WhatABallGrazesOnItsWayDoesNotHoldItsBlow) {
    constexpr btScalar rate = 60, speed = 7;
    constexpr int starts = 20;
    const auto asset = BreakableAsset::fromObj(SHERD_ASSETS "/coffee_cup.obj", Material::ceramic(),
                                               Settings::forQuality(Quality::preview));
    ASSERT_TRUE(asset.ok()) << asset.error();
    for (int i = 0; i < starts; ++i) {
        TestWorld scene;
        scene.world->setGravity(btVector3(0, 0, -9.81f));
        scene.addFloor();
        FractureWorld fracture(scene.world.get());
        ASSERT_TRUE(fracture.setBudget(Budget::none()).ok());
        ASSERT_TRUE(fracture.add(asset.value(), at(0, 0, 0.001f)).ok());
        const btScalar back = speed / rate * btScalar(i) / starts;
        scene.addBall(2, 0.05, btVector3(-0.5f - back, 0.01f, 0.06f), btVector3(speed, 0, 0));
        EXPECT_EQ(stepUntilBreak(scene, fracture, 12, 1 / rate).outcome, broke) << back << " m behind";
    }
}

TEST(Break, PiecesStandWhereTheMaterialWas) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    const btTransform start(btQuaternion(btVector3(0.3f, 1, 0.2f), 0.7f), btVector3(0.4f, 0.5f, 0.6f));
    btRigidBody* body = fracture.add(plate(crumbly()), start).value();
    const Vec3 up = vec(start.getBasis().getColumn(2));
    const btVector3 above = start * btVector3(0, 0, 0.2f);
    scene.addBall(2, 0.1, above,
                  btVector3(btScalar(-8 * up.x()), btScalar(-8 * up.y()), btScalar(-8 * up.z())));
    const BlowEvent event = stepUntilBreak(scene, fracture);
    ASSERT_EQ(event.outcome, broke) << event.message;
    // One step's motion apart: the plate's corners are corners of pieces.
    const btVector3 corner = start * btVector3(0.3f, 0.3f, 0.03f);
    btScalar nearest = 1;
    for (const btRigidBody* fragment : event.fragments) {
        const btTransform place = fracture.assetTransform(fragment);
        for (const Vec3& v : fracture.asset(fragment)->surface().vertices) {
            const btVector3 x = place * btVector3(btScalar(v.x()), btScalar(v.y()), btScalar(v.z()));
            nearest = std::min(nearest, x.distance(corner));
        }
    }
    EXPECT_LT(nearest, 0.05);
    (void)body;
}

TEST(Break, FragmentsInheritWhatTheAppSet) {
    TestWorld scene;
    scene.world->setGravity(btVector3(0, 0, -10));
    FractureWorld fracture(scene.world.get());
    btRigidBody* body = fracture.add(plate(crumbly()), at(0, 0, 0)).value();
    int tag = 0;
    body->setFriction(0.91f);
    body->setRollingFriction(0.12f);
    body->setRestitution(0.33f);
    body->setDamping(0.05f, 0.07f);
    body->setGravity(btVector3(0, 0, -3));
    body->setUserPointer(&tag);
    body->setUserIndex(17);
    body->setActivationState(DISABLE_DEACTIVATION);
    scene.world->removeRigidBody(body);
    scene.world->addRigidBody(body, 64, 64 | 1);
    body->setGravity(btVector3(0, 0, -3));
    scene.addBall(2, 0.1, btVector3(0, 0, 0.2f), btVector3(0, 0, -8));
    const BlowEvent event = stepUntilBreak(scene, fracture);
    ASSERT_EQ(event.outcome, broke) << event.message;
    for (const btRigidBody* piece : event.fragments) {
        EXPECT_EQ(piece->getFriction(), 0.91f);
        EXPECT_EQ(piece->getRollingFriction(), 0.12f);
        EXPECT_EQ(piece->getRestitution(), 0.33f);
        EXPECT_EQ(piece->getLinearDamping(), 0.05f);
        EXPECT_EQ(piece->getAngularDamping(), 0.07f);
        EXPECT_EQ(piece->getUserPointer(), &tag);
        EXPECT_EQ(piece->getUserIndex(), 17);
        EXPECT_NE(piece->getActivationState(), DISABLE_DEACTIVATION) << "it may sleep";
        EXPECT_EQ(piece->getGravity().z(), -3);
        EXPECT_EQ(piece->getBroadphaseHandle()->m_collisionFilterGroup, 64);
        EXPECT_EQ(piece->getBroadphaseHandle()->m_collisionFilterMask, 65);
    }
}

TEST(Break, WhatTheAppHeldInItsPlaceComesFree) {
    TestWorld scene;
    scene.world->setGravity(btVector3(0, 0, -10));
    scene.addFloor();
    FractureWorld fracture(scene.world.get());
    btRigidBody* body = fracture.add(plate(crumbly()), at(0, 0, 0.5f)).value();
    body->setLinearFactor(btVector3(0, 0, 0));
    body->setAngularFactor(btVector3(0, 0, 0));
    scene.addBall(2, 0.1, btVector3(0, 0, 0.7f), btVector3(0, 0, -8));
    const BlowEvent event = stepUntilBreak(scene, fracture);
    ASSERT_EQ(event.outcome, broke) << event.message;
    for (const btRigidBody* piece : event.fragments) {
        EXPECT_EQ(piece->getLinearFactor(), btVector3(1, 1, 1));
        EXPECT_EQ(piece->getAngularFactor(), btVector3(1, 1, 1));
    }
    scene.step(480);
    for (const btRigidBody* piece : fracture.bodies()) {
        EXPECT_GT(piece->getCenterOfMassPosition().z(), -0.05);
        EXPECT_LT(piece->getCenterOfMassPosition().z(), 0.2);
    }
}

TEST(Break, FragmentsFallLikeTheRestFromTheSubstepOfTheBreakOn) {
    TestWorld scene;
    scene.world->setGravity(btVector3(0, 0, -10));
    FractureWorld fracture(scene.world.get());
    btRigidBody* body = fracture.add(plate(crumbly()), at(0, 0, 0)).value();
    body->setDamping(0, 0);
    btRigidBody* witness = scene.addBall(1, 0.1, btVector3(3, 0, 0));  // falls freely beside
    btRigidBody* ball = scene.addBall(1, 0.1, btVector3(0, 0, 0.1331f), btVector3(0, 0, -4));
    const btScalar dt = btScalar(1) / 240;
    scene.world->stepSimulation(10 * dt, 10,
                                dt);  // one call: gravity is applied once, before the first of ten substeps
    const auto events = fracture.takeEvents();
    ASSERT_FALSE(events.empty());
    ASSERT_EQ(events[0].outcome, broke) << events[0].message;
    std::vector<btRigidBody*> all = fracture.bodies();  // some may have broken again
    all.push_back(ball);
    double mass = 0;
    for (const btRigidBody* b : all) mass += 1.0 / b->getInvMass();
    const double expected = witness->getLinearVelocity().z() * mass + 1 * -4.0;
    EXPECT_NEAR(momentumOf(all).linear.z(), expected, 1e-3 * std::abs(expected));
    EXPECT_NEAR(witness->getLinearVelocity().z(), -10 * 10 * dt, 1e-5);
}

TEST(Break, TwoBodiesMayBreakInOneStep) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    btRigidBody* a = fracture.add(plate(crumbly()), at(0, 0, 0)).value();
    btRigidBody* b = fracture.add(plate(crumbly()), at(0.1f, 0.1f, 0.2f)).value();
    a->setLinearVelocity(btVector3(0, 0, 3));
    b->setLinearVelocity(btVector3(0, 0, -5));
    int broken = 0;
    for (int i = 0; i < 60 && broken == 0; ++i) {
        scene.step();
        for (const BlowEvent& event : fracture.takeEvents()) broken += event.outcome == broke;
    }
    EXPECT_EQ(broken, 2);
    EXPECT_FALSE(inWorld(scene, a));
    EXPECT_FALSE(inWorld(scene, b));
}

TEST(Break, EqualBodiesUnderEqualBlowsDoNotBreakIntoCopies) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    const BreakableAsset asset = plate(crumbly());
    std::vector<std::vector<double>> masses;
    for (const btScalar x : {0.0f, 4.0f}) {
        ASSERT_TRUE(fracture.add(asset, at(x, 0, 0)).ok());
        scene.addBall(2, 0.1, btVector3(x + 0.05f, 0.02f, 0.2f), btVector3(0, 0, -8));
    }
    scene.step(30);
    for (const BlowEvent& event : fracture.takeEvents()) {
        if (event.outcome != broke) continue;
        masses.emplace_back();
        for (const btRigidBody* piece : event.fragments) masses.back().push_back(1.0 / piece->getInvMass());
    }
    ASSERT_EQ(masses.size(), 2u);
    EXPECT_NE(masses[0], masses[1]);
}

TEST(Break, FragmentsBreakAgainAfterTheirRestAndNotBefore) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    Settings settings = coarse(0.06);
    settings.fracture.fragment_count = 2;
    settings.fracture.rest_after_break_s = 0.1;
    settings.fracture.smallest_fragment_m3 = 1e-9;
    const auto asset = BreakableAsset::fromMesh(shapes::box(Vec3(-0.3, -0.3, -0.03), Vec3(0.3, 0.3, 0.03)),
                                                crumbly(), settings);
    ASSERT_TRUE(asset.ok());
    ASSERT_TRUE(fracture.add(asset.value(), at(0, 0, 0)).ok());
    scene.addBall(2, 0.1, btVector3(0, 0, 0.2f), btVector3(0, 0, -8));
    const BlowEvent first = stepUntilBreak(scene, fracture);
    ASSERT_EQ(first.outcome, broke) << first.message;
    btRigidBody* piece = first.fragments.front();
    const auto shoot = [&] {
        const btVector3 centre = piece->getCenterOfMassPosition();
        scene.addBall(20, 0.05, centre - btVector3(0, 0, 0.3f),
                      piece->getLinearVelocity() + btVector3(0, 0, 60));
    };
    shoot();
    scene.step(12);  // 50 ms
    for (const BlowEvent& event : fracture.takeEvents()) EXPECT_NE(event.body, piece);
    scene.step(24);
    bool again = false;
    for (int shot = 0; shot < 5 && !again; ++shot) {
        shoot();
        for (int i = 0; i < 12; ++i) {
            scene.step();
            for (const BlowEvent& event : fracture.takeEvents())
                again = again || (event.body == piece && event.outcome == broke);
            if (again) break;
        }
    }
    EXPECT_TRUE(again);
}

/// How often pieces of a plate break in the 40 ms after a ball broke it, with another ball that is shot at
/// one of them then or without.
int breaksOfPieces(bool shoot, double same_blow_s) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    EXPECT_TRUE(fracture.setBudget(Budget::none()));
    Settings settings = coarse(0.06);
    settings.fracture.fragment_count = 2;
    settings.fracture.same_blow_s = same_blow_s;
    settings.fracture.crack_pattern = CrackPattern::seeds;  // equal pieces, which break again
    settings.fracture.smallest_fragment_m3 = 1e-9;
    const auto asset = BreakableAsset::fromMesh(shapes::box(Vec3(-0.3, -0.3, -0.03), Vec3(0.3, 0.3, 0.03)),
                                                crumbly(), settings);
    EXPECT_TRUE(fracture.add(asset.value(), at(0, 0, 0)).ok());
    scene.addBall(20, 0.1, btVector3(0.1f, 0.05f, 0.2f), btVector3(0, 0, -12));
    const BlowEvent first = stepUntilBreak(scene, fracture);
    EXPECT_EQ(first.outcome, broke) << first.message;
    if (first.outcome != broke) return 0;
    const btRigidBody* piece = first.fragments.front();
    const btVector3 centre = piece->getCenterOfMassPosition();
    if (shoot)
        scene.addBall(20, 0.05, centre - btVector3(0, 0, 0.15f),
                      piece->getLinearVelocity() + btVector3(0, 0, 20));
    int breaks = 0;
    for (int i = 0; i < 10; ++i) {
        scene.step();
        for (const BlowEvent& event : fracture.takeEvents()) breaks += event.outcome == broke;
    }
    return breaks;
}

TEST(Break, YoungFragmentsAreBrokenByWhatComesNewAndNotByTheirOwnBlow) {
    EXPECT_EQ(breaksOfPieces(false, 0.05), 0);
    EXPECT_GT(breaksOfPieces(true, 0.05), 0);
    EXPECT_GT(breaksOfPieces(false, 0), 0) << "nothing was tested";
}

TEST(Break, PiecesBelowTheSmallestSizeAreNeverSolved) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    Settings settings = coarse(0.06);
    settings.fracture.rest_after_break_s = settings.fracture.same_blow_s = 0;
    settings.fracture.smallest_fragment_m3 = 0.6 * 0.6 * 0.06 * 0.99;
    const auto asset = BreakableAsset::fromMesh(shapes::box(Vec3(-0.3, -0.3, -0.03), Vec3(0.3, 0.3, 0.03)),
                                                crumbly(), settings);
    ASSERT_TRUE(asset.ok());
    ASSERT_TRUE(fracture.add(asset.value(), at(0, 0, 0)).ok());
    scene.addBall(2, 0.1, btVector3(0, 0, 0.2f), btVector3(0, 0, -8));
    ASSERT_EQ(stepUntilBreak(scene, fracture).outcome, broke);
    const long long solved = fracture.counts().solved();
    for (btRigidBody* piece : fracture.bodies()) {
        EXPECT_NE(fracture.asset(piece), nullptr);
        scene.addBall(20, 0.05, piece->getCenterOfMassPosition() - btVector3(0, 0, 0.3f),
                      btVector3(0, 0, 60));
    }
    scene.step(24);
    EXPECT_EQ(fracture.counts().solved(), solved);
}

TEST(Break, DroppedDebrisTakesItsMomentumAlong) {
    double mass[2] = {0, 0}, dropped_kg = 0, whole_kg = 0;
    std::size_t count[2];
    for (const bool dropping : {false, true}) {
        TestWorld scene;
        FractureWorld fracture(scene.world.get());
        Settings settings = coarse(0.06);
        settings.fracture.fragment_count = 20;
        settings.fracture.smallest_fragment_m3 = 7e-4;  // of 0.0216
        settings.fracture.debris = dropping ? Debris::dropped : Debris::unbreakable;
        const auto asset = BreakableAsset::fromMesh(
            shapes::box(Vec3(-0.3, -0.3, -0.03), Vec3(0.3, 0.3, 0.03)), crumbly(), settings);
        fracture.add(asset.value(), at(0, 0, 0)).value();
        scene.addBall(2, 0.1, btVector3(0.05, 0.02, 0.2), btVector3(0, 0, -8));
        const BlowEvent event = stepUntilBreak(scene, fracture);
        ASSERT_EQ(event.outcome, broke) << event.message;
        EXPECT_LT(event.momentum_error_rel, 1e-5);
        EXPECT_LT(event.mass_error_rel, 1e-6);
        for (const btRigidBody* body : event.fragments) mass[dropping] += 1 / body->getInvMass();
        count[dropping] = event.fragments.size();
        if (dropping)
            dropped_kg = event.dropped_mass_kg;
        else
            EXPECT_EQ(event.dropped_mass_kg, 0);
        whole_kg = asset.value().mass();
        scene.step(5);
    }
    EXPECT_LT(count[1], count[0]);
    EXPECT_GT(dropped_kg, 0);
    EXPECT_NEAR(mass[0], whole_kg, 1e-5 * whole_kg);
    EXPECT_NEAR(mass[1] + dropped_kg, whole_kg, 1e-5 * whole_kg);
}

}  // namespace
