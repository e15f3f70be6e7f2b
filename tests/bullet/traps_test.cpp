// What goes wrong in Bullet's step when a body is swapped in the middle of it.

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

constexpr auto broke = Outcome::broke;

/// A ball that comes down on a plate about the origin.
btRigidBody* dropBall(TestWorld& scene, btScalar speed = 8, btScalar height = 0.2f) {
    return scene.addBall(2, 0.1, btVector3(0.03f, 0.02f, height), btVector3(0, 0, -speed));
}

bool finite(const btVector3& v) {
    return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
}

void expectCalm(const TestWorld& scene, btScalar fastest) {
    for (int i = 0; i < scene.world->getNumCollisionObjects(); ++i) {
        const btRigidBody* body = btRigidBody::upcast(scene.world->getCollisionObjectArray()[i]);
        if (!body) continue;
        ASSERT_TRUE(finite(body->getCenterOfMassPosition()));
        ASSERT_TRUE(finite(body->getLinearVelocity()));
        EXPECT_LT(body->getLinearVelocity().length(), fastest);
    }
}

/// A callback of the app's that throws where Sherd looks for the contacts of new fragments.
struct ThrowsInTheStep {
    inline static const btContactSolverInfo* info = nullptr;
    static bool processed(btManifoldPoint&, void*, void*) {
        if (info->m_solverMode & SOLVER_USE_WARMSTARTING) throw std::runtime_error("the app's");
        return true;
    }
    explicit ThrowsInTheStep(btDiscreteDynamicsWorld& world) {
        info = &world.getSolverInfo();
        gContactProcessedCallback = processed;
    }
    ~ThrowsInTheStep() { gContactProcessedCallback = nullptr; }
};

/// The end of such a step does not come.
TEST(Traps, WarmStartingIsOffAgainAfterAStepThatACallbackEnded) {
    TestWorld scene;
    btContactSolverInfo& info = scene.world->getSolverInfo();
    info.m_solverMode &= ~SOLVER_USE_WARMSTARTING;
    const btScalar factor = info.m_warmstartingFactor;
    FractureWorld fracture(scene.world.get());
    ASSERT_TRUE(fracture.add(plate(crumbly()), at(0, 0, 0)).ok());
    btRigidBody* ball = dropBall(scene);
    {
        const ThrowsInTheStep callback(*scene.world);
        EXPECT_THROW(scene.step(100), std::runtime_error);
    }
    ball->translate(btVector3(0, 0, 10));  // nothing is struck any more
    scene.step(1);
    EXPECT_FALSE(info.m_solverMode & SOLVER_USE_WARMSTARTING);
    EXPECT_EQ(info.m_warmstartingFactor, factor);
}

TEST(Traps, JointsOfTheBrokenBodyAreTakenOutAndNamed) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    btRigidBody* body = fracture.add(plate(crumbly()), at(0, 0, 0)).value();
    btRigidBody* weight = scene.addBox(1, btVector3(0.05f, 0.05f, 0.05f), btVector3(0.5f, 0, 0));
    btRigidBody* other = scene.addBox(1, btVector3(0.05f, 0.05f, 0.05f), btVector3(0.8f, 0, 0));
    btPoint2PointConstraint joint(*body, *weight, btVector3(0.4f, 0, 0), btVector3(-0.1f, 0, 0));
    btPoint2PointConstraint elsewhere(*weight, *other, btVector3(0.15f, 0, 0), btVector3(-0.15f, 0, 0));
    scene.world->addConstraint(&joint, true);
    scene.world->addConstraint(&elsewhere, true);
    dropBall(scene);
    const BlowEvent event = stepUntilBreak(scene, fracture);
    ASSERT_EQ(event.outcome, broke) << event.message;
    EXPECT_EQ(event.removed_constraints, std::vector<btTypedConstraint*>{&joint});
    EXPECT_EQ(scene.world->getNumConstraints(), 1);
    EXPECT_EQ(weight->getNumConstraintRefs(), 1);
    scene.step(60);
    expectCalm(scene, 20);
    scene.world->removeConstraint(&elsewhere);
}

TEST(Traps, JointThatOnlyTheFirstSolveBrokeStays) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    ASSERT_TRUE(fracture.add(plate(crumbly()), at(0, 0, 0)).ok());
    // A tray that hangs on a weak joint right under the plate: the blow goes through the whole plate and
    // would tear it off.
    btRigidBody* ball = scene.addBall(20, 0.1, btVector3(0, 0, 0.2f), btVector3(0, 0, -8));
    btRigidBody* tail = scene.addBox(4, btVector3(0.05f, 0.05f, 0.05f), btVector3(0, 0, 0.6f));
    btPoint2PointConstraint joint(*ball, *tail, btVector3(0, 0, 0.2f), btVector3(0, 0, -0.2f));
    tail->setLinearVelocity(btVector3(0, 0, -8));
    joint.setBreakingImpulseThreshold(10);
    scene.world->addConstraint(&joint, true);
    const BlowEvent event = stepUntilBreak(scene, fracture);
    ASSERT_EQ(event.outcome, broke) << event.message;
    EXPECT_TRUE(joint.isEnabled()) << "the blow on the whole plate tore it; in the step taken again it holds";
    scene.world->removeConstraint(&joint);
}

/// A solver of the app's that does something of its own when the step is solved.
struct SolverWithATask final : btSequentialImpulseConstraintSolver {
    std::function<void()> task;
    void allSolved(const btContactSolverInfo& info, btIDebugDraw* drawer) override {
        btSequentialImpulseConstraintSolver::allSolved(info, drawer);
        task();
    }
};

TEST(Traps, WhatTheAppTakesOutDuringTheSolveIsStruckByNothing) {
    for (const bool takes_ball : {false, true}) {
        TestWorld scene;
        SolverWithATask solver;
        scene.world->setConstraintSolver(&solver);
        FractureWorld fracture(scene.world.get());
        btRigidBody* struck = fracture.add(plate(crumbly()), at(0, 0, 0)).value();
        ASSERT_TRUE(fracture.add(plate(crumbly()), at(5, 0, 0)).ok());
        // In the same step another ball breaks the other plate, or this one.
        scene.addBall(2, 0.1, btVector3(takes_ball ? -0.2f : 5, 0, 0.129f), btVector3(0, 0, -8));
        btRigidBody* ball = scene.addBall(2, 0.05, btVector3(0.05f, 0, 0.5f), btVector3(0, 0, -40));
        ball->setCcdMotionThreshold(0.02f);
        ball->setCcdSweptSphereRadius(0.04f);
        btRigidBody* const leaves = takes_ball ? ball : struck;
        solver.task = [&] {
            for (int i = 0; i < scene.dispatcher->getNumManifolds(); ++i) {
                const btPersistentManifold& manifold = *scene.dispatcher->getManifoldByIndexInternal(i);
                const bool foreseen = manifold.getBody0() == ball && manifold.getBody1() == struck;
                if (foreseen && leaves->isInWorld()) scene.world->removeRigidBody(leaves);
            }
        };
        scene.step(1, 1.0 / 60);
        EXPECT_FALSE(leaves->isInWorld());
        const std::vector<BlowEvent> events = fracture.takeEvents();
        ASSERT_EQ(events.size(), 1u);
        EXPECT_EQ(events[0].outcome, broke);
        EXPECT_EQ(events[0].body == struck, takes_ball);
        scene.step(30, 1.0 / 60);
        expectCalm(scene, 60);
    }
}

TEST(Traps, SleepingNeighbourWakesAndFalls) {
    TestWorld scene;
    scene.world->setGravity(btVector3(0, 0, -10));
    FractureWorld fracture(scene.world.get());
    scene.addBox(0, btVector3(0.05f, 0.3f, 0.2f), btVector3(-0.25f, 0, -0.231f));
    scene.addBox(0, btVector3(0.05f, 0.3f, 0.2f), btVector3(0.25f, 0, -0.231f));
    btRigidBody* body = fracture.add(plate(Material::plaster()), at(0, 0, 0)).value();
    btRigidBody* neighbour = scene.addBox(0.2, btVector3(0.05f, 0.05f, 0.05f), btVector3(0.1f, 0.1f, 0.081f));
    scene.step(1500);
    ASSERT_FALSE(body->isActive());
    ASSERT_FALSE(neighbour->isActive());
    ASSERT_GT(neighbour->getCenterOfMassPosition().z(), 0.05f);
    // Removal by the app first: the same road out of the world.
    fracture.remove(body);
    EXPECT_TRUE(neighbour->isActive());
    scene.step(120);
    EXPECT_LT(neighbour->getCenterOfMassPosition().z(), 0);
}

TEST(Traps, NeighbourAsleepOnThePlateFallsWithThePieces) {
    TestWorld scene;
    scene.world->setGravity(btVector3(0, 0, -10));
    FractureWorld fracture(scene.world.get());
    scene.addBox(0, btVector3(0.05f, 0.3f, 0.2f), btVector3(-0.25f, 0, -0.231f));
    scene.addBox(0, btVector3(0.05f, 0.3f, 0.2f), btVector3(0.25f, 0, -0.231f));
    btRigidBody* body = fracture.add(plate(Material::plaster()), at(0, 0, 0)).value();
    btRigidBody* neighbour = scene.addBox(0.2, btVector3(0.05f, 0.05f, 0.05f), btVector3(0.1f, 0.1f, 0.081f));
    scene.step(1500);
    ASSERT_FALSE(neighbour->isActive());
    ASSERT_TRUE(inWorld(scene, body));
    scene.addBall(20, 0.1, btVector3(-0.05f, -0.1f, 0.3f), btVector3(0, 0, -20));
    ASSERT_EQ(stepUntilBreak(scene, fracture).outcome, broke);
    EXPECT_TRUE(neighbour->isActive());
    scene.step(240);
    EXPECT_LT(neighbour->getCenterOfMassPosition().z(), 0.03f);
}

TEST(Traps, PredictedContactBreaksAndDoesNotOutliveTheBody) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    btRigidBody* body = fracture.add(plate(crumbly()), at(0, 0, 0)).value();
    btRigidBody* ball = scene.addBall(2, 0.05, btVector3(0.03f, 0.02f, 1.03f), btVector3(0, 0, -100));
    ball->setCcdMotionThreshold(0.02f);
    ball->setCcdSweptSphereRadius(0.05f);
    BlowEvent event = stepUntilBreak(scene, fracture, 20, 1.0 / 60);
    ASSERT_EQ(event.outcome, broke) << event.message;
    EXPECT_NEAR(event.position.z(), 0.03, 0.02)
        << "the point of a predicted contact is a centre, not a surface";
    EXPECT_FALSE(inWorld(scene, body));
    for (int i = 0; i < scene.dispatcher->getNumManifolds(); ++i) {
        EXPECT_NE(scene.dispatcher->getManifoldByIndexInternal(i)->getBody0(), body);
        EXPECT_NE(scene.dispatcher->getManifoldByIndexInternal(i)->getBody1(), body);
    }
    EXPECT_LT(ball->getLinearVelocity().z(), -50);
    scene.step(20, 1.0 / 60);
    expectCalm(scene, 200);
}

TEST(Traps, SplitImpulseOfTheFirstSolveIsUndone) {
    // The ball starts deep in the plate: the first solve moves both apart by their transforms.
    TestWorld scene;
    scene.world->getSolverInfo().m_splitImpulse = true;
    scene.world->getSolverInfo().m_splitImpulsePenetrationThreshold = 0;
    FractureWorld fracture(scene.world.get());
    btRigidBody* body = fracture.add(plate(crumbly()), at(0, 0, 0)).value();
    body->setLinearVelocity(btVector3(0, 0, 0));
    btRigidBody* bystander =
        scene.addBall(0.01, 0.02, btVector3(0.25f, 0.25f, -0.045f));  // touches the plate from below
    scene.addBall(50, 0.1, btVector3(-0.1f, -0.1f, 0.09f), btVector3(0, 0, -8));
    const BlowEvent event = stepUntilBreak(scene, fracture, 5);
    ASSERT_EQ(event.outcome, broke) << event.message;
    for (const btRigidBody* piece : event.fragments) {
        const BreakableAsset& asset = *fracture.asset(piece);
        double low = 1, high = -1;
        const btTransform place = fracture.assetTransform(piece);
        for (const Vec3& v : asset.surface().vertices) {
            const btScalar z = (place * btVector3(btScalar(v.x()), btScalar(v.y()), btScalar(v.z()))).z();
            low = std::min<double>(low, z);
            high = std::max<double>(high, z);
        }
        // Only the push of its own solve and one step of its own velocity.
        const double moved =
            std::abs(piece->getLinearVelocity().z()) / 240 + 0.3 * piece->getAngularVelocity().length() / 240;
        EXPECT_GT(low, -0.03 - moved - 0.02);
        EXPECT_LT(high, 0.03 + moved + 0.02);
    }
    (void)bystander;
}

TEST(Traps, BreaksWithWarmStartingOffAndLeavesTheSettingsAlone) {
    TestWorld scene;
    btContactSolverInfo& info = scene.world->getSolverInfo();
    info.m_solverMode &= ~SOLVER_USE_WARMSTARTING;
    info.m_warmstartingFactor = 0.77f;
    FractureWorld fracture(scene.world.get());
    ASSERT_TRUE(fracture.add(plate(crumbly()), at(0, 0, 0)).ok());
    dropBall(scene);
    const BlowEvent event = stepUntilBreak(scene, fracture);
    EXPECT_EQ(event.outcome, broke) << "no impulses are written back";
    EXPECT_FALSE(info.m_solverMode & SOLVER_USE_WARMSTARTING);
    EXPECT_EQ(info.m_warmstartingFactor, 0.77f);
}

/// The place of the plate in the one contact that there is, 0 or 1, and what became of it. The striker is a
/// compound, too, so that Bullet keeps the order of the pair, which is that in which the bodies came into the
/// world.
int placeOfPlate(bool plate_first, BlowEvent& event) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    btRigidBody* body = nullptr;
    if (plate_first) body = fracture.add(plate(crumbly()), at(0, 0, 0)).value();
    scene.shapes.push_back(std::make_unique<btSphereShape>(0.1f));
    auto striker = std::make_unique<btCompoundShape>();
    striker->addChildShape(at(0, 0, 0), scene.shapes.back().get());
    scene.addBody(std::move(striker), 2, btVector3(0.03f, 0.02f, 0.2f))
        ->setLinearVelocity(btVector3(0, 0, -8));
    if (!plate_first) body = fracture.add(plate(crumbly()), at(0, 0, 0)).value();
    const auto& pairs = scene.world->getPairCache()->getOverlappingPairArray();
    int place = -1;
    for (int i = 0; i < 60 && event.outcome != broke; ++i) {
        if (pairs.size() > 0) place = pairs[0].m_pProxy0->m_clientObject == body ? 0 : 1;
        event = stepUntilBreak(scene, fracture, 1);
    }
    return place;
}

TEST(Traps, CompoundIsStruckAsFirstAndAsSecondBodyOfAContact) {
    for (const bool plate_first : {true, false}) {
        BlowEvent event = noBreak();
        EXPECT_EQ(placeOfPlate(plate_first, event), plate_first ? 0 : 1);
        ASSERT_EQ(event.outcome, broke);
        EXPECT_LT(event.normal.z(), -0.99) << "pushed the wrong way";
        EXPECT_NEAR(event.position.z(), 0.03, 0.01);
    }
}

/// A plate that every contact is looked at of, though none could break it.
void addRestingPlate(FractureWorld& fracture) {
    BodyOptions options(at(0, 0, 0.03f));
    const BreakableAsset asset = plate(Material::plaster());
    options.fracture = asset.settings().fracture;
    options.fracture->check_with_full_solve = true;
    fracture.add(asset, options).value()->setActivationState(DISABLE_DEACTIVATION);
}

TEST(Traps, StaleImpulsesOfPointsThatTheSolverLeavesOutAreIgnored) {
    TestWorld scene;
    scene.world->setGravity(btVector3(0, 0, -10));
    scene.addFloor();
    FractureWorld fracture(scene.world.get());
    addRestingPlate(fracture);
    scene.step(30);
    ASSERT_GT(fracture.counts().seen, 0);
    for (int i = 0; i < scene.dispatcher->getNumManifolds(); ++i)
        scene.dispatcher->getManifoldByIndexInternal(i)->setContactProcessingThreshold(-1);
    const long long seen = fracture.counts().seen;
    scene.step(2);
    ASSERT_GT(scene.dispatcher->getManifoldByIndexInternal(0)->getNumContacts(), 0);
    EXPECT_EQ(fracture.counts().seen, seen);
}

TEST(Traps, StaleImpulsesOfAPairWithoutResponseAreIgnored) {
    TestWorld scene;
    scene.world->setGravity(btVector3(0, 0, -10));
    btRigidBody* floor = scene.addFloor();
    FractureWorld fracture(scene.world.get());
    addRestingPlate(fracture);
    scene.step(30);
    ASSERT_GT(fracture.counts().seen, 0);
    floor->setCollisionFlags(floor->getCollisionFlags() | btCollisionObject::CF_NO_CONTACT_RESPONSE);
    const long long seen = fracture.counts().seen;
    scene.step(1);
    EXPECT_EQ(fracture.counts().seen, seen);
}

TEST(Traps, OtherBroadphasesFindTheFragmentsContacts) {
    for (const bool sweep : {true, false}) {
        TestWorld scene;
        scene.world.reset();
        if (sweep)
            scene.broadphase =
                std::make_unique<btAxisSweep3>(btVector3(-10, -10, -10), btVector3(10, 10, 10));
        else
            scene.broadphase = std::make_unique<btSimpleBroadphase>();
        scene.world = std::make_unique<btDiscreteDynamicsWorld>(
            scene.dispatcher.get(), scene.broadphase.get(), scene.solver.get(), scene.configuration.get());
        scene.world->setGravity(btVector3(0, 0, 0));
        FractureWorld fracture(scene.world.get());
        ASSERT_TRUE(fracture.add(plate(crumbly()), at(0, 0, 0)).ok());
        btRigidBody* ball = dropBall(scene);
        const BlowEvent event = stepUntilBreak(scene, fracture);
        ASSERT_EQ(event.outcome, broke);
        EXPECT_GT(ball->getLinearVelocity().z(), -8) << "the ball went through without touching a piece";
    }
}

TEST(Traps, TwoHooksGoInAnyOrder) {
    TestWorld scene;
    auto first = std::make_unique<FractureWorld>(scene.world.get());
    auto second = std::make_unique<FractureWorld>(scene.world.get());
    btRigidBody* body = second->add(plate(crumbly()), at(0, 0, 0)).value();
    scene.step(1);
    first.reset();
    scene.addBall(5, 0.1, btVector3(0, 0, 0.3f), btVector3(0, 0, -20));
    ASSERT_EQ(stepUntilBreak(scene, *second).outcome, broke);
    EXPECT_FALSE(inWorld(scene, body));
    second.reset();
    scene.step(10);
}

/// Of all bodies, along z.
double momentumOf(const TestWorld& scene) {
    double sum = 0;
    const auto& objects = scene.world->getCollisionObjectArray();
    for (int i = 0; i < objects.size(); ++i) {
        const btRigidBody* body = btRigidBody::upcast(objects[i]);
        if (body->getInvMass() > 0) sum += double(body->getLinearVelocity().z()) / body->getInvMass();
    }
    return sum;
}

TEST(Traps, BodiesOfTwoHooksBreakInOneStepAndKeepTheirMomentum) {
    TestWorld scene;
    FractureWorld inner(scene.world.get()), outer(scene.world.get());
    const BreakableAsset asset = plate(crumbly());
    ASSERT_TRUE(inner.add(asset, at(-0.32f, 0, 0)).ok());
    ASSERT_TRUE(outer.add(asset, at(0.32f, 0, 0)).ok());
    btRigidBody* box = scene.addBox(5, btVector3(0.2f, 0.1f, 0.1f), btVector3(0, 0, 0.2f));
    box->setLinearVelocity(btVector3(0, 0, -8));
    int together = 0;
    for (int i = 0; i < 12; ++i) {
        scene.step();
        EXPECT_NEAR(momentumOf(scene), -40, 1e-3) << "step " << i;
        const auto of_inner = inner.takeEvents(), of_outer = outer.takeEvents();
        together += !of_inner.empty() && !of_outer.empty();
    }
    EXPECT_EQ(together, 1) << "they were to break in the same step";
}

TEST(Traps, ABlowThatWaitsAtOneHookIsNotUndoneByAnother) {
    TestWorld scene;
    FractureWorld inner(scene.world.get()), outer(scene.world.get());
    btRigidBody* pushed = inner.add(plate(unbreakable()), at(0, 0, -0.0601f)).value();
    ASSERT_TRUE(outer.add(plate(crumbly()), at(0, 0, 0)).ok());
    scene.addBall(5, 0.1, btVector3(0, 0, 0.129f), btVector3(0, 0, -8));
    static std::function<void()> task;
    task = [&] { EXPECT_TRUE(inner.applyBlow(pushed, {btVector3(0, 0, -0.06f), btVector3(30, 0, 0)}).ok()); };
    scene.dispatcher->setNearCallback(
        [](btBroadphasePair& pair, btCollisionDispatcher& dispatcher, const btDispatcherInfo& info) {
            if (task) std::exchange(task, nullptr)();
            btCollisionDispatcher::defaultNearCallback(pair, dispatcher, info);
        });
    scene.step();
    ASSERT_GT(outer.bodies().size(), 1u) << "the outer hook was to solve the step again";
    double momentum = 0;
    for (int i = 0; i < scene.world->getNumCollisionObjects(); ++i) {
        const btRigidBody* body = btRigidBody::upcast(scene.world->getCollisionObjectArray()[i]);
        momentum += double(body->getLinearVelocity().x()) / body->getInvMass();
    }
    scene.dispatcher->setNearCallback(&btCollisionDispatcher::defaultNearCallback);
    EXPECT_NEAR(momentum, 30, 0.01);
}

TEST(Traps, AnotherBodyAtTheSameAddressIsNotBreakable) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    btBoxShape small(btVector3(0.1f, 0.1f, 0.1f)), large(btVector3(1, 1, 1));
    const btVector3 inertia(1, 1, 1);
    std::optional<btRigidBody> slot;
    slot.emplace(btRigidBody::btRigidBodyConstructionInfo(8, nullptr, &small, inertia));
    btRigidBody* const address = &*slot;
    scene.world->addRigidBody(address);
    ASSERT_TRUE(fracture.makeBreakable(address, Material::plaster()).ok());
    scene.step(1);
    scene.world->removeRigidBody(address);
    scene.world->addRigidBody(address);
    EXPECT_NE(fracture.asset(address), nullptr) << "put back, it is still itself";
    scene.world->removeRigidBody(address);
    slot.emplace(btRigidBody::btRigidBodyConstructionInfo(8000, nullptr, &large, inertia));
    scene.world->addRigidBody(address);
    EXPECT_EQ(fracture.asset(address), nullptr);
    scene.step(1);
    EXPECT_TRUE(fracture.bodies().empty());
    scene.world->removeRigidBody(address);
}

TEST(Traps, WhatWasNailedDownDoesNotBreak) {
    for (const bool kinematic : {false, true}) {
        TestWorld scene;
        FractureWorld fracture(scene.world.get());
        btRigidBody* body = fracture.add(plate(crumbly()), at(0, 0, 0)).value();
        if (kinematic)
            body->setCollisionFlags(body->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
        else
            body->setMassProps(0, btVector3(0, 0, 0));
        scene.addBall(5, 0.1, btVector3(0, 0, 0.3f), btVector3(0, 0, -20));
        scene.step(60);
        for (const BlowEvent& event : fracture.takeEvents()) EXPECT_EQ(event.outcome, Outcome::failed);
        EXPECT_TRUE(inWorld(scene, body));
    }
}

// Bullet's manual adds the flag to a body of mass 0, which is flagged as static already.
TEST(Traps, WhatTheAppMovesBreaksWhatItStrikes) {
    for (const int flags : {btCollisionObject::CF_KINEMATIC_OBJECT + 0,
                            btCollisionObject::CF_KINEMATIC_OBJECT | btCollisionObject::CF_STATIC_OBJECT})
        for (const bool asleep : {false, true}) {
            TestWorld scene;
            FractureWorld fracture(scene.world.get());
            btRigidBody* body = fracture.add(plate(crumbly()), at(0, 0, 0)).value();
            if (asleep) body->forceActivationState(ISLAND_SLEEPING);
            btRigidBody* hammer = scene.addBox(0, btVector3(0.1f, 0.1f, 0.1f), btVector3(0, 0, 0.2f));
            hammer->setCollisionFlags(flags);
            hammer->forceActivationState(DISABLE_DEACTIVATION);
            btDefaultMotionState path(hammer->getWorldTransform());
            hammer->setMotionState(&path);
            BlowEvent event = noBreak();
            for (int step = 0; step < 30 && event.outcome != Outcome::broke; ++step) {
                path.m_graphicsWorldTrans.getOrigin() -= btVector3(0, 0, 2.0f / 240);
                event = stepUntilBreak(scene, fracture, 1);
            }
            EXPECT_EQ(event.outcome, Outcome::broke) << "flags " << flags << ", asleep " << asleep;
            EXPECT_EQ(event.striker, hammer);
            EXPECT_NEAR(event.asset_transform.getOrigin().z(), 0, 1e-6) << "by the first touch";
            hammer->setMotionState(nullptr);
        }
}

}  // namespace
