// Every kind of Bullet world.

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <BulletDynamics/Featherstone/btMultiBodyPoint2Point.h>
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftBodyHelpers.h>

#include <functional>
#include <memory>
#include <stdexcept>

#include "bullet/support.h"
#include "bullet/world/world_internals.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

constexpr auto broke = Outcome::broke;

class EveryWorld : public testing::TestWithParam<WorldKind> {};

TEST_P(EveryWorld, PlateBreaksAndTheBallGoesOn) {
    TestWorld scene(GetParam());
    FractureWorld fracture(scene.world.get());
    ASSERT_TRUE(fracture.add(plate(crumbly()), at(0, 0, 0)).ok());
    btRigidBody* ball = scene.addBall(20, 0.1, btVector3(0, 0, 0.3f), btVector3(0, 0, -20));
    const BlowEvent event = stepUntilBreak(scene, fracture);
    ASSERT_EQ(event.outcome, broke) << event.message;
    EXPECT_LT(event.momentum_error_rel, 1e-5);
    scene.step(60);
    EXPECT_LT(ball->getLinearVelocity().z(), -12);
}

TEST_P(EveryWorld, HasItsOwnSolverBackAfterwards) {
    TestWorld scene(GetParam());
    btConstraintSolver* const own = scene.world->getConstraintSolver();
    {
        FractureWorld fracture(scene.world.get());
        EXPECT_NE(scene.world->getConstraintSolver(), own);
        for (const auto type : {BT_SEQUENTIAL_IMPULSE_SOLVER, BT_MLCP_SOLVER, BT_NNCG_SOLVER,
                                BT_MULTIBODY_SOLVER, BT_BLOCK_SOLVER})
            EXPECT_NE(scene.world->getConstraintSolver()->getSolverType(), type) << "an app may cast it";
        EXPECT_FALSE(WorldInternals::ownsSolver(*scene.world));
        ASSERT_TRUE(fracture.add(plate(crumbly()), at(0, 0, 0)).ok());
        scene.addBall(2, 0.1, btVector3(0, 0, 0.2f), btVector3(0, 0, -8));
        scene.step(20);
    }
    EXPECT_EQ(scene.world->getConstraintSolver(), own);
    EXPECT_EQ(WorldInternals::ownsSolver(*scene.world), GetParam() == WorldKind::owns_its_solver);
    EXPECT_EQ(scene.world->getNumCollisionObjects(), 1) << "only the app's ball is left";
    scene.step(20);
}

std::string nameOf(const testing::TestParamInfo<WorldKind>& info) {
    static constexpr const char* names[] = {"plain", "owns_its_solver", "threaded", "soft", "multi_body"};
    return names[static_cast<int>(info.param)];
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryWorld,
                         testing::Values(WorldKind::plain, WorldKind::owns_its_solver, WorldKind::threaded,
                                         WorldKind::soft, WorldKind::multi_body),
                         nameOf);

/// Says what it is, as solvers of apps may.
class OutspokenSolver : public btMultiBodyConstraintSolver {
  public:
    btConstraintSolverType getSolverType() const override { return BT_MULTIBODY_SOLVER; }
};

TEST(MultiBodyWorld, IsNotToldThatTheHookIsAMultiBodySolver) {
    TestWorld scene(WorldKind::multi_body);
    auto& world = static_cast<btMultiBodyDynamicsWorld&>(*scene.world);
    OutspokenSolver solver;
    world.setMultiBodyConstraintSolver(&solver);
    {
        FractureWorld fracture(&world);
        EXPECT_NE(world.getConstraintSolver()->getSolverType(), BT_MULTIBODY_SOLVER)
            << "the world would cast it";
        scene.addBall(1, 0.1, btVector3(0, 0, 0));
        scene.step(2);
    }
    EXPECT_EQ(world.getConstraintSolver(), &solver);
    scene.step(2);
}

TEST(SoftWorld, ClothOnThePlateSurvivesTheBreak) {
    TestWorld scene(WorldKind::soft);
    scene.world->setGravity(btVector3(0, 0, -10));
    auto* soft_world = static_cast<btSoftRigidDynamicsWorld*>(scene.world.get());
    soft_world->getWorldInfo().m_gravity = btVector3(0, 0, -10);
    soft_world->getWorldInfo().m_sparsesdf.Initialize();
    scene.addFloor();
    FractureWorld fracture(scene.world.get());
    ASSERT_TRUE(fracture.add(plate(crumbly()), at(0, 0, 0.5f)).ok());
    btSoftBody* cloth = btSoftBodyHelpers::CreatePatch(
        soft_world->getWorldInfo(), btVector3(-0.2f, -0.2f, 0.6f), btVector3(0.2f, -0.2f, 0.6f),
        btVector3(-0.2f, 0.2f, 0.6f), btVector3(0.2f, 0.2f, 0.6f), 8, 8, 0, true);
    cloth->setTotalMass(0.2f);
    soft_world->addSoftBody(cloth);
    int breaks = 0;
    for (int i = 0; i < 240; ++i) {
        scene.step();
        for (const BlowEvent& event : fracture.takeEvents()) breaks += event.outcome == broke;
    }
    EXPECT_GT(breaks, 0);
    for (int n = 0; n < cloth->m_nodes.size(); ++n) {
        ASSERT_TRUE(std::isfinite(cloth->m_nodes[n].m_x.z()));
        EXPECT_GT(cloth->m_nodes[n].m_x.z(), -0.5);
    }
    soft_world->removeSoftBody(cloth);
    delete cloth;
}

/// A free multi-body of one base without links.
struct MultiBodyBall {
    MultiBodyBall(btMultiBodyDynamicsWorld& its_world, btScalar mass, btScalar radius,
                  const btVector3& position, const btVector3& velocity)
        : world(its_world), shape(radius) {
        btVector3 inertia;
        shape.calculateLocalInertia(mass, inertia);
        multi_body = std::make_unique<btMultiBody>(0, mass, inertia, false, false);
        multi_body->finalizeMultiDof();
        multi_body->setBasePos(position);
        multi_body->setBaseVel(velocity);
        multi_body->setLinearDamping(0);
        multi_body->setAngularDamping(0);
        world.addMultiBody(multi_body.get());
        collider = std::make_unique<btMultiBodyLinkCollider>(multi_body.get(), -1);
        collider->setCollisionShape(&shape);
        collider->setWorldTransform(btTransform(btQuaternion::getIdentity(), position));
        world.addCollisionObject(collider.get(), 1, -1);
        multi_body->setBaseCollider(collider.get());
    }
    ~MultiBodyBall() {
        world.removeCollisionObject(collider.get());
        world.removeMultiBody(multi_body.get());
    }

    btMultiBodyDynamicsWorld& world;
    btSphereShape shape;
    std::unique_ptr<btMultiBody> multi_body;
    std::unique_ptr<btMultiBodyLinkCollider> collider;
};

TEST(MultiBodyWorld, MultiBodyThatBreaksThePlateGoesOnToo) {
    TestWorld scene(WorldKind::multi_body);
    auto& world = static_cast<btMultiBodyDynamicsWorld&>(*scene.world);
    FractureWorld fracture(&world);
    btRigidBody* body = fracture.add(plate(crumbly()), at(0, 0, 0)).value();
    const double plate_mass = fracture.asset(body)->mass();
    MultiBodyBall ball(world, 20, 0.1f, btVector3(0, 0, 0.3f), btVector3(0, 0, -20));
    const BlowEvent event = stepUntilBreak(scene, fracture);
    ASSERT_EQ(event.outcome, broke) << event.message;
    EXPECT_LT(ball.multi_body->getBaseVel().z(), -12) << "it bounced off the plate as if that had held";
    double momentum = 20.0 * ball.multi_body->getBaseVel().z();
    for (const btRigidBody* piece : event.fragments)
        momentum += piece->getLinearVelocity().z() / piece->getInvMass();
    EXPECT_NEAR(momentum, -400, 0.01) << "plate of " << plate_mass << " kg";
    scene.step(60);
    EXPECT_LT(ball.multi_body->getBasePos().z(), -1);
}

/// Speed of a ball after a plate struck it at 8 m/s and broke, with or without a pin that holds the ball.
/// With two FractureWorlds the plate belongs to the outer one.
double ballSpeedAfterBreak(bool pinned, int fracture_worlds = 1) {
    TestWorld scene(WorldKind::multi_body);
    auto& world = static_cast<btMultiBodyDynamicsWorld&>(*scene.world);
    std::unique_ptr<FractureWorld> within;
    if (fracture_worlds == 2) within = std::make_unique<FractureWorld>(&world);
    FractureWorld fracture(&world);
    btRigidBody* body = fracture.add(plate(crumbly()), at(0, 0, 0)).value();
    body->setLinearVelocity(btVector3(0, 0, 8));
    MultiBodyBall ball(world, 2, 0.1f, btVector3(0, 0, 0.3f), btVector3(0, 0, 0));
    btMultiBodyPoint2Point pin(ball.multi_body.get(), -1, nullptr, btVector3(0, 0, 0), btVector3(0, 0, 0.3f));
    pin.setMaxAppliedImpulse(1e6f);
    pin.finalizeMultiDof();
    if (pinned) world.addMultiBodyConstraint(&pin);
    const BlowEvent event = stepUntilBreak(scene, fracture);
    EXPECT_EQ(event.outcome, broke) << event.message;
    if (pinned) world.removeMultiBodyConstraint(&pin);
    return ball.multi_body->getBaseVel().length();
}

// Bullet's iterations leave a pin that is struck so hard some speed; left out, it would leave all of it.
TEST(MultiBodyWorld, ConstraintsOfMultiBodiesHoldInTheStepTakenAgain) {
    const double held = ballSpeedAfterBreak(true), free = ballSpeedAfterBreak(false);
    EXPECT_GT(free, 2);
    EXPECT_LT(held, 0.2 * free) << "the pin was left out";
    EXPECT_EQ(ballSpeedAfterBreak(true, 2), held);
}

TEST(MultiBodyWorld, ClosingSpeedOfAMultiBodyIsKnown) {
    TestWorld scene(WorldKind::multi_body);
    auto& world = static_cast<btMultiBodyDynamicsWorld&>(*scene.world);
    FractureWorld fracture(&world);
    Material strong = Material::plaster();
    ASSERT_TRUE(fracture.add(plate(strong), at(0, 0, 0)).ok());
    // So slow that nothing can break, then so fast that it must be looked at.
    MultiBodyBall slow(world, 2, 0.05f, btVector3(0.1f, 0, 0.09f), btVector3(0, 0, -0.001f));
    scene.step(30);
    EXPECT_EQ(fracture.counts().solved(), 0);
    MultiBodyBall fast(world, 2, 0.05f, btVector3(-0.1f, 0, 0.3f), btVector3(0, 0, -10));
    scene.step(30);
    EXPECT_GT(fracture.counts().solved(), 0);
}

/// A world of deformable bodies, with all that Bullet wants beside it.
struct DeformableScene {
    DeformableScene() { world.setGravity(btVector3(0, 0, 0)); }
    btSoftBodyRigidBodyCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btDeformableBodySolver body_solver;
    btDeformableMultiBodyConstraintSolver solver;
    btDeformableMultiBodyDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration, &body_solver};
};

TEST(NoWorld, IsRefusedWithASentence) {
    try {
        FractureWorld fracture(nullptr);
        FAIL() << "there is no world";
    } catch (const std::invalid_argument& trouble) {
        EXPECT_STREQ(trouble.what(), "FractureWorld was given no world (nullptr); make the world first.");
    }
}

TEST(DeformableWorld, IsRefusedWithASentence) {
    DeformableScene scene;
    scene.solver.setDeformableSolver(&scene.body_solver);
    {
        FractureWorld fracture(&scene.world);
        const auto added = fracture.add(plate(crumbly()), at(0, 0, 0));
        ASSERT_FALSE(added.ok());
        EXPECT_NE(added.error().find("btDeformableMultiBodyDynamicsWorld"), std::string::npos)
            << added.error();
        btBoxShape box(btVector3(0.1f, 0.1f, 0.1f));
        btRigidBody body(1, nullptr, &box, btVector3(1, 1, 1));
        scene.world.addRigidBody(&body);
        const Status made = fracture.makeBreakable(&body, crumbly());
        ASSERT_FALSE(made.ok());
        EXPECT_NE(made.error().find("btDeformableMultiBodyDynamicsWorld"), std::string::npos) << made.error();
        for (int i = 0; i < 3; ++i) scene.world.stepSimulation(btScalar(1.0 / 240), 0);
        scene.world.removeRigidBody(&body);
    }
    scene.world.stepSimulation(btScalar(1.0 / 240), 0);
}

/// A plate that is pinned to a multi-body, and breaks or is removed.
struct PinnedPlate {
    PinnedPlate() {
        pin.setMaxAppliedImpulse(1e6f);
        pin.finalizeMultiDof();
        world.addMultiBodyConstraint(&pin);
        scene.step(2);
    }
    ~PinnedPlate() { world.removeMultiBodyConstraint(&pin); }

    TestWorld scene{WorldKind::multi_body};
    btMultiBodyDynamicsWorld& world = static_cast<btMultiBodyDynamicsWorld&>(*scene.world);
    FractureWorld fracture{&world};
    btRigidBody* body = fracture.add(plate(crumbly(), 0.1), at(0, 0, 0)).value();
    MultiBodyBall weight{world, 2, 0.05f, btVector3(0.4f, 0, 0), btVector3(0, 0, 0)};
    btMultiBodyPoint2Point pin{weight.multi_body.get(), -1, body, btVector3(-0.05f, 0, 0),
                               btVector3(0.35f, 0, 0)};
};

TEST(MultiBodyWorld, ConstraintsOfABrokenBodyAreRemovedAndNamed) {
    PinnedPlate plate;
    plate.scene.addBall(2, 0.1, btVector3(0, 0, 0.2f), btVector3(0, 0, -8));
    const BlowEvent event = stepUntilBreak(plate.scene, plate.fracture);
    ASSERT_EQ(event.outcome, broke) << event.message;
    EXPECT_EQ(event.removed_multi_body_constraints, std::vector<btMultiBodyConstraint*>{&plate.pin});
    EXPECT_EQ(plate.world.getNumMultiBodyConstraints(), 0);
    plate.scene.step(20);
}

TEST(MultiBodyWorld, ConstraintsOfARemovedBodyGoWithIt) {
    PinnedPlate plate;
    plate.fracture.remove(plate.body);
    EXPECT_EQ(plate.world.getNumMultiBodyConstraints(), 0);
    plate.scene.step(20);
}

/// Speed that a blow on a rigid box leaves to a multi-body that is pinned to it, when something breaks in
/// that step.
TEST(MultiBodyWorld, PinsToRigidBodiesHoldInTheStepTakenAgain) {
    TestWorld scene(WorldKind::multi_body);
    auto& world = static_cast<btMultiBodyDynamicsWorld&>(*scene.world);
    FractureWorld fracture(&world);
    btRigidBody* body = fracture.add(plate(crumbly()), at(0, 0, 0)).value();
    body->setLinearVelocity(btVector3(0, 0, 8));
    btRigidBody* box = scene.addBox(2, btVector3(0.1f, 0.1f, 0.1f), btVector3(0, 0, 0.3f));
    MultiBodyBall heavy(world, 1000, 0.05f, btVector3(0, 0, 0.5f), btVector3(0, 0, 0));
    btMultiBodyPoint2Point pin(heavy.multi_body.get(), -1, box, btVector3(0, 0, -0.2f), btVector3(0, 0, 0));
    pin.setMaxAppliedImpulse(1e6f);
    pin.finalizeMultiDof();
    world.addMultiBodyConstraint(&pin);
    const BlowEvent event = stepUntilBreak(scene, fracture);
    ASSERT_EQ(event.outcome, broke) << event.message;
    EXPECT_LT(box->getLinearVelocity().z(), 0.5) << "the pin to the heavy ball was left out";
    world.removeMultiBodyConstraint(&pin);
}

TEST(SoftWorld, ClothThatIsAnchoredToABodyThatBreaksIsFree) {
    for (const bool remove : {false, true}) {
        TestWorld scene(WorldKind::soft);
        auto* soft_world = static_cast<btSoftRigidDynamicsWorld*>(scene.world.get());
        soft_world->getWorldInfo().m_sparsesdf.Initialize();
        FractureWorld fracture(scene.world.get());
        btRigidBody* body = fracture.add(plate(crumbly(), 0.1), at(0, 0, 0)).value();
        btSoftBody* cloth = btSoftBodyHelpers::CreatePatch(
            soft_world->getWorldInfo(), btVector3(0.35f, -0.2f, 0), btVector3(0.75f, -0.2f, 0),
            btVector3(0.35f, 0.2f, 0), btVector3(0.75f, 0.2f, 0), 5, 5, 0, true);
        cloth->setTotalMass(0.2f);
        soft_world->addSoftBody(cloth);
        cloth->appendAnchor(0, body, true);
        cloth->appendAnchor(5, body, true);
        scene.step(2);
        if (remove)
            fracture.remove(body);
        else
            scene.addBall(2, 0.1, btVector3(0, 0, 0.2f), btVector3(0, 0, -8));
        scene.step(30);
        EXPECT_EQ(fracture.asset(body), nullptr);
        EXPECT_EQ(cloth->m_anchors.size(), 0);
        fracture.takeEvents();
        scene.step(10);
        for (int n = 0; n < cloth->m_nodes.size(); ++n) {
            EXPECT_TRUE(std::isfinite(cloth->m_nodes[n].m_x.z()));
            EXPECT_EQ(cloth->m_nodes[n].m_battach, 0);
        }
        soft_world->removeSoftBody(cloth);
        delete cloth;
    }
}

TEST(SoftWorld, ClothIsFreeOfAFractureWorldThatIsDestroyedBeforeItsOwnSolve) {
    TestWorld scene(WorldKind::soft);
    scene.world->setGravity(btVector3(0, 0, -10));
    auto* soft_world = static_cast<btSoftRigidDynamicsWorld*>(scene.world.get());
    soft_world->getWorldInfo().m_gravity = btVector3(0, 0, -10);
    soft_world->getWorldInfo().m_sparsesdf.Initialize();
    scene.addFloor();
    auto fracture = std::make_unique<FractureWorld>(scene.world.get());
    btRigidBody* body = fracture->add(plate(unbreakable()), at(0, 0, 0.03f)).value();
    btSoftBody* cloth = btSoftBodyHelpers::CreatePatch(
        soft_world->getWorldInfo(), btVector3(-0.2f, -0.2f, 0.1f), btVector3(0.2f, -0.2f, 0.1f),
        btVector3(-0.2f, 0.2f, 0.1f), btVector3(0.2f, 0.2f, 0.1f), 8, 8, 0, true);
    cloth->setTotalMass(0.2f);
    soft_world->addSoftBody(cloth);
    const auto contacts = [&] {
        int count = 0;
        for (int i = 0; i < cloth->m_rcontacts.size(); ++i)
            count += cloth->m_rcontacts[i].m_cti.m_colObj == body;
        return count;
    };
    int found = 0, left = 0;
    std::function<void()> tick = [&] {  // after the rigid bodies, before the soft ones
        if (contacts() == 0) return;
        found = contacts();
        fracture.reset();
        left = contacts();
        tick = [] {};
    };
    scene.world->setInternalTickCallback(
        [](btDynamicsWorld* world, btScalar) {
            const auto now = *static_cast<std::function<void()>*>(world->getWorldUserInfo());
            now();
        },
        &tick);
    for (int i = 0; i < 200 && fracture; ++i) scene.step();
    scene.step(10);
    EXPECT_GT(found, 0) << "the cloth never lay on the plate";
    EXPECT_EQ(left, 0);
    soft_world->removeSoftBody(cloth);
    delete cloth;
}

}  // namespace
