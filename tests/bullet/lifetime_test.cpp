// Bodies that come and go, and what is asked for at the wrong moment.

#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

constexpr auto broke = Outcome::broke;

/// A compound of two boxes, 0.6 x 0.3 x 0.06 m in all, with the mass and frame that the app chose.
btRigidBody* addAppsBody(TestWorld& scene, double mass = 7) {
    scene.shapes.push_back(std::make_unique<btBoxShape>(btVector3(0.15f, 0.15f, 0.03f)));
    btCollisionShape* part = scene.shapes.back().get();
    auto compound = std::make_unique<btCompoundShape>();
    compound->addChildShape(at(-0.15f, 0, 0), part);
    compound->addChildShape(at(0.15f, 0, 0), part);
    return scene.addBody(std::move(compound), mass, btVector3(0, 0, 0));
}

TEST(MakeBreakable, BodiesThatAreAlikeShareTheirAsset) {
    TestWorld scene;
    btBoxShape brick(btVector3(0.1f, 0.05f, 0.05f)), another(btVector3(0.1f, 0.05f, 0.05f)),
        longer(btVector3(0.2f, 0.05f, 0.05f));
    btCylinderShape column(btVector3(0.1f, 0.3f, 0.1f));
    std::vector<std::unique_ptr<btRigidBody>> bodies;
    FractureWorld fracture(scene.world.get());
    const auto breakable = [&](btCollisionShape& shape, btScalar mass, const BreakableOptions& options = {}) {
        btVector3 inertia;
        shape.calculateLocalInertia(mass, inertia);
        bodies.push_back(std::make_unique<btRigidBody>(mass, nullptr, &shape, inertia));
        bodies.back()->setWorldTransform(at(btScalar(bodies.size()), 0, 0));
        scene.world->addRigidBody(bodies.back().get());
        EXPECT_TRUE(fracture.makeBreakable(bodies.back().get(), Material::brick(), {}, options).ok());
        return bodies.back().get();
    };
    BreakableOptions of_its_own;
    of_its_own.seed = 3;
    btRigidBody *first = breakable(brick, 2), *seeded = breakable(brick, 2, of_its_own);
    const auto solidOf = [&](const btRigidBody* body) { return fracture.asset(body)->solid(); };
    EXPECT_EQ(solidOf(breakable(brick, 2)), solidOf(first));
    EXPECT_EQ(solidOf(breakable(another, 2)), solidOf(first));
    EXPECT_NE(solidOf(breakable(longer, 2)), solidOf(first));
    EXPECT_EQ(solidOf(breakable(column, 5)), solidOf(breakable(column, 5)));
    EXPECT_NE(solidOf(breakable(brick, 3)), solidOf(first)) << "another density";
    ASSERT_TRUE(fracture.asset(first)->prepare().ok());
    EXPECT_TRUE(fracture.asset(seeded)->prepared());
    for (const auto& body : bodies) scene.world->removeRigidBody(body.get());
}

TEST(MakeBreakable, WhatWasPreparedServesTheNextBodiesWhenAllAreGone) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    btBoxShape brick(btVector3(0.1f, 0.05f, 0.05f));
    std::vector<std::unique_ptr<btBoxShape>> others;
    const auto withBody = [&](btCollisionShape& shape, const std::function<void(btRigidBody*)>& use) {
        btVector3 inertia;
        shape.calculateLocalInertia(2, inertia);
        btRigidBody body(2, nullptr, &shape, inertia);
        scene.world->addRigidBody(&body);
        ASSERT_TRUE(fracture.makeBreakable(&body, Material::brick()).ok());
        use(&body);
        fracture.remove(&body);
        scene.world->removeRigidBody(&body);
    };
    const auto otherBodies = [&](int count) {
        for (int i = 0; i < count; ++i) {
            others.push_back(std::make_unique<btBoxShape>(btVector3(0.1f, 0.1f + 0.01f * i, 0.1f)));
            withBody(*others.back(), [](btRigidBody*) {});
        }
    };
    withBody(brick, [&](btRigidBody* body) { ASSERT_TRUE(fracture.asset(body)->prepare().ok()); });
    otherBodies(7);
    withBody(brick, [&](btRigidBody* body) { EXPECT_TRUE(fracture.asset(body)->prepared()); });
    otherBodies(8);
    withBody(brick, [&](btRigidBody* body) {
        EXPECT_FALSE(fracture.asset(body)->prepared()) << "of more than eight kinds the oldest are let go";
    });
}

TEST(MakeBreakable, AppsCompoundBreaksAndKeepsItsMass) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    btRigidBody* body = addAppsBody(scene);
    const Status made = fracture.makeBreakable(body, crumbly(), coarse(0.06));
    ASSERT_TRUE(made.ok()) << made.error();
    EXPECT_NEAR(fracture.asset(body)->mass(), 7, 1e-5);
    EXPECT_NEAR(fracture.asset(body)->volume(), 0.6 * 0.3 * 0.06, 1e-6);
    body->setLinearVelocity(btVector3(0.3f, 0, 0));
    body->setMassProps(7, btVector3(0.02f, 0.1f, 0.1f));  // not the inertia of the solid
    body->updateInertiaTensor();
    body->setAngularVelocity(btVector3(1, 2, 3));
    scene.addBall(2, 0.1, btVector3(0.05f, 0, 0.2f), btVector3(0, 0, -8));
    const BlowEvent event = stepUntilBreak(scene, fracture);
    ASSERT_EQ(event.outcome, broke) << event.message;
    EXPECT_EQ(event.body, body);
    EXPECT_FALSE(inWorld(scene, body));
    EXPECT_LT(event.momentum_error_rel, 1e-5);
    double mass = 0;
    for (const btRigidBody* piece : event.fragments) mass += 1.0 / piece->getInvMass();
    EXPECT_NEAR(mass, 7, 1e-4);
    EXPECT_EQ(body->getInvMass(), btScalar(1) / 7) << "the body itself is the app's and alive";
}

TEST(MakeBreakable, ConvexBodiesAreTaken) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    btRigidBody* box = scene.addBox(3, btVector3(0.1f, 0.2f, 0.3f), btVector3(0, 0, 0));
    EXPECT_TRUE(fracture.makeBreakable(box, Material::plaster()).ok());
    EXPECT_NEAR(fracture.asset(box)->volume(), 8 * 0.1 * 0.2 * 0.3, 1e-6);
    btRigidBody* ball = scene.addBall(3, 0.2, btVector3(2, 0, 0));
    const Status made = fracture.makeBreakable(ball, Material::plaster());
    EXPECT_TRUE(made.ok()) << made.error();
    EXPECT_NEAR(fracture.asset(ball)->mass(), 3, 1e-6);
}

TEST(MakeBreakable, RefusesWithASentence) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    const Material material = Material::plaster();
    btRigidBody* unset = scene.addBox(8, btVector3(0.1f, 0.1f, 0.1f), btVector3(3, 0, 0));
    unset->setMassProps(8, btVector3(1, NAN, 1));
    EXPECT_NE(fracture.makeBreakable(unset, material).error().find("not a finite number"), std::string::npos);
    scene.world->removeRigidBody(unset);
    EXPECT_EQ(fracture.makeBreakable(nullptr, material).error(),
              "there is no body to make breakable (nullptr)");
    btRigidBody* floor = scene.addFloor();
    EXPECT_EQ(fracture.makeBreakable(floor, material).error(),
              "the body is static, so it can break only where something holds it: name the parts of its "
              "surface that "
              "are held (BreakableOptions::supports), or give it a mass");
    btRigidBody* body = addAppsBody(scene);
    scene.world->removeRigidBody(body);
    EXPECT_EQ(fracture.makeBreakable(body, material).error(),
              "the body is not in this world; add it with addRigidBody first");
    scene.world->addRigidBody(body);
    ASSERT_TRUE(fracture.makeBreakable(body, material).ok());
    EXPECT_EQ(fracture.makeBreakable(body, material).error(), "the body is breakable already");
    btRigidBody* bare = scene.addBox(1, btVector3(0.1f, 0.1f, 0.1f), btVector3(3, 0, 0));
    btCollisionShape* const shape = bare->getCollisionShape();
    bare->setCollisionShape(nullptr);
    EXPECT_EQ(fracture.makeBreakable(bare, material).error(),
              "the body has no collision shape; give it one first");
    bare->setCollisionShape(shape);
}

TEST(MakeBreakable, RefusesShapesThatAreNoConvexSolids) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    auto compound = std::make_unique<btCompoundShape>();
    scene.shapes.push_back(std::make_unique<btStaticPlaneShape>(btVector3(0, 0, 1), 0));
    compound->addChildShape(at(0, 0, 0), scene.shapes.back().get());
    scene.shapes.push_back(std::make_unique<btBoxShape>(btVector3(1, 1, 1)));
    btRigidBody* body =
        scene.addBody(std::make_unique<btBoxShape>(btVector3(1, 1, 1)), 1, btVector3(0, 0, 0));
    body->setCollisionShape(compound.get());
    const std::string sentence = fracture.makeBreakable(body, Material::plaster()).error();
    EXPECT_NE(sentence.find("STATICPLANE"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("not a convex solid"), std::string::npos) << sentence;
    scene.world->removeRigidBody(body);
    body->setCollisionShape(scene.shapes.back().get());

    auto empty = std::make_unique<btCompoundShape>();
    body->setCollisionShape(empty.get());
    scene.world->addRigidBody(body);
    EXPECT_NE(fracture.makeBreakable(body, Material::plaster()).error().find("no children"),
              std::string::npos);
    scene.world->removeRigidBody(body);
}

/// Asks for things from inside the step, where Bullet calls the app.
struct Intruder {
    static Intruder*& current() {
        static Intruder* intruder = nullptr;
        return intruder;
    }
    static void whileColliding(btBroadphasePair& pair, btCollisionDispatcher& dispatcher,
                               const btDispatcherInfo& info) {
        Intruder& self = *current();
        self.sentence = self.fracture->add(*self.asset, at(5, 5, 5)).error();
        self.refusal = self.fracture->makeBreakable(self.apps_body, Material::plaster()).error();
        self.fracture->remove(self.to_remove);
        btCollisionDispatcher::defaultNearCallback(pair, dispatcher, info);
    }
    FractureWorld* fracture = nullptr;
    const BreakableAsset* asset = nullptr;
    btRigidBody *apps_body = nullptr, *to_remove = nullptr;
    std::string sentence, refusal;
};

TEST(MidStep, AddAndMakeBreakableAreRefusedAndRemoveWaits) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    const BreakableAsset asset = plate(unbreakable());
    Intruder intruder;
    intruder.fracture = &fracture;
    intruder.asset = &asset;
    intruder.to_remove = fracture.add(asset, at(0, 0, 0)).value();
    intruder.apps_body = scene.addBall(1, 0.1, btVector3(0, 0, 0.12f));
    Intruder::current() = &intruder;
    scene.dispatcher->setNearCallback(&Intruder::whileColliding);
    scene.step();
    scene.dispatcher->setNearCallback(&btCollisionDispatcher::defaultNearCallback);
    EXPECT_EQ(intruder.sentence,
              "a body cannot be added while the world is inside a step; add it after stepSimulation");
    EXPECT_EQ(intruder.refusal,
              "a body cannot be made breakable while the world is inside a step; do it after stepSimulation");
    EXPECT_TRUE(fracture.bodies().empty());
    EXPECT_EQ(scene.world->getNumCollisionObjects(), 1);
    EXPECT_EQ(fracture.add(asset, at(0, 0, 0)).error(), "") << "after the step it works again";
}

TEST(Lifetime, BodyThatTheAppTookOutIsForgottenIfItIsTheApps) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    {
        btBoxShape shape(btVector3(0.2f, 0.2f, 0.2f));
        auto body = std::make_unique<btRigidBody>(btScalar(2), nullptr, &shape, btVector3(1, 1, 1));
        scene.world->addRigidBody(body.get());
        ASSERT_TRUE(fracture.makeBreakable(body.get(), crumbly()).ok());
        scene.addBall(2, 0.1, btVector3(0, 0, 0.31f), btVector3(0, 0, -1));
        scene.world->removeRigidBody(body.get());
    }  // and deleted
    scene.step(10);
    EXPECT_TRUE(fracture.bodies().empty());
    EXPECT_EQ(fracture.counts().seen, 0);
}

TEST(Lifetime, OwnBodyThatTheAppTookOutMayComeBack) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    btRigidBody* body = fracture.add(plate(crumbly()), at(0, 0, 0)).value();
    scene.world->removeRigidBody(body);
    scene.step(3);
    EXPECT_TRUE(fracture.bodies().empty());
    EXPECT_NE(fracture.asset(body), nullptr);
    scene.world->addRigidBody(body);
    scene.addBall(2, 0.1, btVector3(0, 0, 0.2f), btVector3(0, 0, -8));
    EXPECT_EQ(stepUntilBreak(scene, fracture).outcome, broke);
}

TEST(Lifetime, RemoveTakesJointsAlong) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    btRigidBody* body = fracture.add(plate(crumbly()), at(0, 0, 0)).value();
    btRigidBody* weight = scene.addBox(1, btVector3(0.05f, 0.05f, 0.05f), btVector3(0.5f, 0, 0));
    btPoint2PointConstraint joint(*body, *weight, btVector3(0.4f, 0, 0), btVector3(-0.1f, 0, 0));
    scene.world->addConstraint(&joint);
    fracture.remove(body);
    fracture.remove(body);    // a second time: nothing
    fracture.remove(weight);  // not ours: nothing
    EXPECT_EQ(scene.world->getNumConstraints(), 0);
    EXPECT_EQ(scene.world->getNumCollisionObjects(), 1);
    scene.step(3);
    EXPECT_EQ(fracture.asset(body), nullptr);
}

TEST(Lifetime, EventsAreHandedOutOnceAndTheirBodiesLiveUntilTheNextStep) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    int tag = 0;
    fracture.add(plate(crumbly()), at(0, 0, 0)).value()->setUserPointer(&tag);
    scene.addBall(2, 0.1, btVector3(0, 0, 0.2f), btVector3(0, 0, -8));
    scene.step(60);
    const auto events = fracture.takeEvents();
    ASSERT_FALSE(events.empty());
    EXPECT_EQ(events.front().body->getUserPointer(), &tag);
    EXPECT_TRUE(fracture.takeEvents().empty());
}

/// A motion state that runs a piece of a test once when it is told a place.
struct MeddlingState : btDefaultMotionState {
    void setWorldTransform(const btTransform& place) override {
        btDefaultMotionState::setWorldTransform(place);
        if (task) std::exchange(task, nullptr)();
    }
    std::function<void()> task;
};

TEST(Lifetime, MotionStateMayMeddleWhileItsBodyIsAdded) {
    const BreakableAsset asset = plate(crumbly(), 0.1);
    MeddlingState motion_state;
    BodyOptions options;
    options.motion_state = &motion_state;
    {
        TestWorld scene;
        auto fracture = std::make_unique<FractureWorld>(scene.world.get());
        ASSERT_TRUE(fracture->add(asset, at(3, 0, 0)).ok());
        motion_state.task = [&] { fracture.reset(); };
        EXPECT_EQ(fracture->add(asset, options).error(),
                  "the FractureWorld was destroyed by a callback while the body was added");
        EXPECT_EQ(scene.world->getNumCollisionObjects(), 0);
        scene.step(2);
    }
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    btRigidBody* other = fracture.add(asset, at(3, 0, 0)).value();
    std::string refusal;
    motion_state.task = [&] {
        refusal = fracture.add(asset, at(6, 0, 0)).error();
        fracture.remove(other);
    };
    btRigidBody* body = fracture.add(asset, options).value();
    EXPECT_NE(refusal.find("inside a step"), std::string::npos) << refusal;
    EXPECT_EQ(fracture.bodies(), std::vector<btRigidBody*>{body});
}

TEST(Lifetime, AnotherFractureWorldThatACallbackDestroysGoesAtOnce) {
    TestWorld scene;
    FractureWorld first(scene.world.get());
    auto second = std::make_unique<FractureWorld>(scene.world.get());
    const BreakableAsset asset = plate(crumbly(), 0.1);
    btRigidBody* body = first.add(asset, at(0, 0, 0)).value();
    ASSERT_TRUE(second->add(asset, at(2, 0, 0)).ok());
    first.onFragment([&](FragmentBirth&) { second.reset(); });
    ASSERT_TRUE(first.applyBlow(body, {btVector3(0, 0, 0.03f), btVector3(0, 0, -50)}).ok());
    EXPECT_EQ(scene.world->getNumCollisionObjects(), int(first.bodies().size()));
    scene.step(2);
}

TEST(Lifetime, AppMayPutInAnotherSolverWhileHooked) {
    TestWorld scene(WorldKind::owns_its_solver);
    btSequentialImpulseConstraintSolver other;
    {
        FractureWorld fracture(scene.world.get());
        ASSERT_TRUE(fracture.add(plate(crumbly()), at(0, 0, 0)).ok());
        scene.step(2);
        scene.world->setConstraintSolver(&other);
        scene.step(2);
        const std::string gone =
            "bodies cannot break in this world any more: its constraint solver was set after the "
            "FractureWorld was made; make that after setConstraintSolver";
        EXPECT_EQ(fracture.add(plate(crumbly()), at(0, 0, 1)).error(), gone);
        const auto events = fracture.takeEvents();
        ASSERT_EQ(events.size(), 1u) << "once for the body, not in each step";
        EXPECT_EQ(events[0].outcome, Outcome::failed);
        EXPECT_EQ(events[0].message, gone);
        EXPECT_EQ(events[0].body, fracture.bodies().front());
        btRigidBody* body = addAppsBody(scene);
        EXPECT_EQ(fracture.makeBreakable(body, crumbly(), coarse(0.1)).error(), gone);
    }
    EXPECT_EQ(scene.world->getConstraintSolver(), &other);
    scene.step(2);
}

TEST(Lifetime, AnAppsBodyMayGoWhileAnotherSolverIsInPlace) {
    TestWorld scene;
    btSequentialImpulseConstraintSolver other;
    FractureWorld fracture(scene.world.get());
    btRigidBody* body = addAppsBody(scene);
    ASSERT_TRUE(fracture.makeBreakable(body, crumbly(), coarse(0.1)).ok());
    scene.world->setConstraintSolver(&other);
    scene.world->removeRigidBody(body);
    scene.bodies.pop_back();  // which deletes it
    scene.step(3);
    EXPECT_TRUE(fracture.takeEvents().empty());
}

TEST(Lifetime, ABodyThatTheAppMakesStaticIsToldOf) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    const auto body = fracture.add(plate(crumbly()), at(0, 0, 0));
    ASSERT_TRUE(body.ok());
    ASSERT_TRUE(fracture.add(plate(crumbly()), at(2, 0, 0)).ok());
    scene.step(2);
    EXPECT_TRUE(fracture.takeEvents().empty());
    body.value()->setMassProps(0, btVector3(0, 0, 0));
    scene.step(3);
    const auto events = fracture.takeEvents();
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].body, body.value());
    EXPECT_NE(events[0].message.find("its mass is 0"), std::string::npos);
}

TEST(Frames, BodyStandsWhereTheAssetWasPlaced) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    // Neither centred nor along its axes.
    const TriangleMesh skew =
        shapes::moved(shapes::box(Vec3(0, 0, 0), Vec3(0.6, 0.4, 0.2)), shapes::tilt(), Vec3(1, 2, 3));
    const auto asset = BreakableAsset::fromMesh(skew, Material::plaster(), coarse(0.1));
    ASSERT_TRUE(asset.ok()) << asset.error();
    const btTransform start(btQuaternion(btVector3(1, 1, 0), 0.5f), btVector3(0.1f, 0.2f, 0.3f));
    btRigidBody* body = fracture.add(asset.value(), start).value();
    const btTransform found = fracture.assetTransform(body);
    EXPECT_LT(found.getOrigin().distance(start.getOrigin()), 1e-5);
    EXPECT_LT((found.getBasis() * btVector3(1, 2, 3)).distance(start.getBasis() * btVector3(1, 2, 3)), 1e-5);
    // The inertia of a box about its own axes, m/12 (b^2 + c^2), smallest first.
    const double mass = asset.value().mass();
    std::vector<double> inertia;
    for (int axis = 0; axis < 3; ++axis) inertia.push_back(1.0 / body->getInvInertiaDiagLocal()[axis]);
    std::sort(inertia.begin(), inertia.end());
    EXPECT_NEAR(inertia[0] / mass, (0.4 * 0.4 + 0.2 * 0.2) / 12, 1e-6);
    EXPECT_NEAR(inertia[1] / mass, (0.6 * 0.6 + 0.2 * 0.2) / 12, 1e-6);
    EXPECT_NEAR(inertia[2] / mass, (0.6 * 0.6 + 0.4 * 0.4) / 12, 1e-6);
}

/// How everything moves at the end of a run, and how often something broke.
struct RunResult {
    std::vector<btScalar> numbers;
    int breaks = 0;
};

RunResult runOnce(std::uint64_t seed) {
    TestWorld scene;
    scene.world->setGravity(btVector3(0, 0, -9.81f));
    scene.addFloor();
    FractureWorld fracture(scene.world.get());
    Settings settings = coarse(0.06);
    settings.strength.seed = settings.fracture.seed = seed;
    const auto asset = BreakableAsset::fromMesh(shapes::box(Vec3(-0.3, -0.3, -0.03), Vec3(0.3, 0.3, 0.03)),
                                                crumbly(), settings);
    for (int i = 0; i < 2; ++i) EXPECT_TRUE(fracture.add(asset.value(), at(0, 0, 0.5f + btScalar(i))).ok());
    scene.addBall(2, 0.1, btVector3(0.05f, 0, 2), btVector3(0, 0, -8));
    scene.step(240);
    RunResult result;
    for (const BlowEvent& event : fracture.takeEvents()) result.breaks += event.outcome == broke;
    for (const btRigidBody* body : fracture.bodies()) {
        btScalar matrix[16];
        body->getWorldTransform().getOpenGLMatrix(matrix);
        result.numbers.insert(result.numbers.end(), matrix, matrix + 16);
        for (int axis = 0; axis < 3; ++axis) {
            result.numbers.push_back(body->getLinearVelocity()[axis]);
            result.numbers.push_back(body->getAngularVelocity()[axis]);
        }
    }
    return result;
}

TEST(Determinism, SameRunTwiceGivesTheSameBits) {
    const RunResult first = runOnce(1), second = runOnce(1), other = runOnce(2);
    EXPECT_GT(first.breaks, 1);
    EXPECT_EQ(first.breaks, second.breaks);
    EXPECT_EQ(first.numbers, second.numbers);
    EXPECT_NE(first.numbers, other.numbers) << "another seed, another break";
}

}  // namespace
