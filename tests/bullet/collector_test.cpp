// What a solved contact says about a blow, and how momentum and forces are shared out: by themselves, without
// a break.

#include <cmath>

#include "bullet/fragments/fragment_motion.h"
#include "bullet/strikes/contact_collector.h"
#include "bullet/support.h"
#include "bullet/world/conversions.h"
#include "core/numerics/pi.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

/// A box of 0.2 x 0.2 x 0.2 m and 4 kg above a floor, moving down, seen by a collector over one step.
struct OneStep {
    explicit OneStep(btScalar speed, btScalar gravity = -10) {
        scene.world->setGravity(btVector3(0, 0, gravity));
        body->setGravity(btVector3(0, 0, gravity));
        body->setLinearVelocity(btVector3(0.02f, 0, -speed));
        const auto asset =
            BreakableAsset::fromMesh(shapes::box(Vec3(-0.1, -0.1, -0.1), Vec3(0.1, 0.1, 0.1)), crumbly());
        auto breakable = std::make_unique<Breakable>(
            asset.value(), fractureSettingsFor(asset.value(), asset.value().settings().fracture));
        breakable->body = body;
        registry.add(std::move(breakable));
        before.take(*scene.world);
        scene.step();
    }
    std::vector<StruckBreakable> struck(double time_s = 0) {
        ContactCollector collector(registry, before, time_s, scene.world->getSolverInfo());
        feedSolvedContacts(*scene.world, collector);
        return collector.takeStruck();
    }

    TestWorld scene;
    btRigidBody* floor = scene.addFloor();
    btRigidBody* body = scene.addBox(4, btVector3(0.1f, 0.1f, 0.1f), btVector3(0, 0, 0.0999f));
    BreakableRegistry registry;
    StepSnapshot before;
};

TEST(Collector, SumsUpToTheImpulseThatStoppedTheBody) {
    OneStep step(2);
    const auto struck = step.struck();
    ASSERT_EQ(struck.size(), 1u);
    Vec3 impulse = Vec3::Zero();
    for (const ContactImpulse& contact : struck[0].blow.contacts) {
        impulse += contact.impulse;
        EXPECT_NEAR(contact.approach_m_s, 2 + 5.0 / 240, 1e-3) << "half a step of gravity is still to come";
        EXPECT_LT((contact.normal - Vec3::UnitZ()).norm(), 1e-5);
        EXPECT_NEAR(contact.point.z(), -0.1, 1e-3);
    }
    const btVector3 gained = step.body->getLinearVelocity() - btVector3(0.02f, 0, -2);
    EXPECT_NEAR(impulse.z(), 4 * (gained.z() + 10.0 / 240), 1e-3);
    EXPECT_NEAR(impulse.x(), 4 * gained.x(), 1e-3) << "friction";
    EXPECT_LT(impulse.x(), 0);
}

TEST(Collector, SpeedOfAStepOrTwoOfFreeFallIsThatOfABodyAtRest) {
    const auto approach = [](btScalar speed, btScalar gravity) {
        OneStep step(speed, gravity);
        return step.struck().at(0).blow.contacts.at(0).approach_m_s;
    };
    EXPECT_EQ(approach(10.f / 240, -10), 0);
    EXPECT_NEAR(approach(30.f / 240, -10), 30.0 / 240, 0.02);
    EXPECT_NEAR(approach(10.f / 240, 0), 10.0 / 240, 1e-5) << "without gravity it is a blow";
}

TEST(Collector, SpeedIsThatOfTheMomentOfTouchWhateverTheTimeStep) {
    for (const double rate : {60.0, 120.0, 240.0, 960.0})
        for (const double height : {0.5, 0.517, 1.0}) {
            TestWorld scene;
            scene.world->setGravity(btVector3(0, 0, btScalar(-9.81)));
            scene.addFloor();
            btRigidBody* body =
                scene.addBox(4, btVector3(0.1f, 0.1f, 0.1f), btVector3(0, 0, btScalar(height + 0.1)));
            const auto asset =
                BreakableAsset::fromMesh(shapes::box(Vec3(-0.1, -0.1, -0.1), Vec3(0.1, 0.1, 0.1)), crumbly());
            BreakableRegistry registry;
            auto breakable = std::make_unique<Breakable>(
                asset.value(), fractureSettingsFor(asset.value(), asset.value().settings().fracture));
            breakable->body = body;
            registry.add(std::move(breakable));
            StepSnapshot before;
            std::vector<StruckBreakable> struck;
            while (struck.empty()) {
                before.take(*scene.world);
                scene.step(1, 1 / rate);
                ContactCollector collector(registry, before, 0, scene.world->getSolverInfo());
                feedSolvedContacts(*scene.world, collector);
                struck = collector.takeStruck();
            }
            const double speed = std::sqrt(2 * 9.81 * height);
            for (const ContactImpulse& contact : struck[0].blow.contacts)
                EXPECT_NEAR(contact.approach_m_s, speed, 0.003 * speed) << rate << " Hz, " << height << " m";
        }
}

/// A ball that strikes a plate aslant and is found up to a step later, deep in it or beyond, further along
/// it: the blow is that of the moment at which they met. Depths are up to the ball's diameter.
TEST(FractureWorld, ASlantingStrikeDoesNotDependOnWhereInAStepItFalls) {
    struct Struck {
        double force_n = 0, stress_pa = 0, x = 0;
    };
    const BreakableAsset asset = plate(Material::plaster());
    for (const double friction : {0.0, 0.5})
        for (const double angle : {30.0, 45.0}) {
            const double speed = 4, slope = angle * pi / 180;
            const Vec3 way(std::sin(slope), 0, -std::cos(slope));
            const auto struck = [&](double rate_hz, double phase) {
                TestWorld scene;
                FractureWorld fracture(scene.world.get());
                EXPECT_TRUE(fracture.setBudget(Budget::none()));
                btRigidBody* body = fracture.add(asset, {}).value();
                body->setFriction(btScalar(friction));
                const Vec3 start = Vec3(0.05, 0.04, 0.06) - way * (2 + phase) * speed / rate_hz;
                btRigidBody* ball = scene.addBall(1, 0.03, toBullet(start), toBullet(Vec3(speed * way)));
                ball->setFriction(1);
                for (int step = 0; step < 8; ++step) {
                    scene.step(1, 1 / rate_hz);
                    for (const BlowEvent& event : fracture.takeEvents())
                        return Struck{event.peak_force_n, event.largest_stress_pa, event.position.x()};
                }
                ADD_FAILURE() << "no event at " << rate_hz << " Hz, phase " << phase;
                return Struck{};
            };
            const Struck exact = struck(960, 0.5);
            EXPECT_NEAR(exact.x, 0.05, 0.002);
            for (const double rate_hz : {60.0, 120.0, 240.0})
                for (const double phase : {0.2, 0.4, 0.6, 0.8}) {
                    const Struck found = struck(rate_hz, phase);
                    const auto where = ::testing::Message() << friction << " friction, " << angle
                                                            << " degrees, " << rate_hz << " Hz, " << phase;
                    EXPECT_NEAR(found.force_n, exact.force_n, 0.01 * exact.force_n) << where;
                    EXPECT_NEAR(found.stress_pa, exact.stress_pa, 0.03 * exact.stress_pa) << where;
                    EXPECT_NEAR(found.x, 0.05, 0.002) << where;
                }
        }
}

TEST(Collector, ForcesOfTheAppAreNoRest) {
    for (const btScalar force : {0.f, -400.f, -4e4f}) {
        OneStep step(2);
        step.body->applyCentralForce(btVector3(0, 0, force));
        EXPECT_NEAR(step.struck().at(0).blow.contacts.at(0).approach_m_s, 2, 0.03) << force;
    }
}

TEST(Collector, PartnersHaveNumbersAndGiveWayAsTheyDo) {
    OneStep step(2);
    btRigidBody* other = step.scene.addBox(3, btVector3(0.1f, 0.1f, 0.1f), btVector3(0, 0, 0.2999f));
    step.body->setLinearVelocity(btVector3(0, 0, -2));
    other->setLinearVelocity(btVector3(0, 0, -3));
    step.before.take(*step.scene.world);
    step.scene.step();
    const auto struck = step.struck();
    ASSERT_EQ(struck.size(), 1u);
    const Blow& blow = struck[0].blow;
    ASSERT_EQ(blow.partners.size(), 2u);
    for (const ContactImpulse& contact : blow.contacts) {
        const Mobility partner = blow.partner(contact.partner);
        const bool below = contact.normal.z() > 0;
        EXPECT_EQ(struck[0].partners[contact.partner], below ? step.floor : other);
        EXPECT_EQ(partner.fixed(), below);
        if (below) continue;
        EXPECT_NEAR(partner.mass(), 3, 1e-5);
        EXPECT_NEAR(partner.centre.z(), 0.2, 2e-2);
        // A corner of a cube: 1/m + (r x n) . J^-1 (r x n) with J = m a^2 / 6.
        EXPECT_NEAR(contact.normal.dot(partner.at(contact.point) * contact.normal),
                    1 / 3.0 + 2 * 0.1 * 0.1 / (3 * 0.2 * 0.2 / 6), 1e-2);
    }
}

TEST(Collector, SleepingBodiesKeepTheirImpulsesToThemselves) {
    OneStep step(2);
    ASSERT_FALSE(step.struck().empty());
    step.body->forceActivationState(ISLAND_SLEEPING);
    EXPECT_TRUE(step.struck().empty());
}

TEST(Collector, BodiesThatRestFromTheirBirthAreLeftAlone) {
    OneStep step(2);
    step.registry.find(step.body)->unbreakable_until_s = 1;
    EXPECT_TRUE(step.struck(0.99).empty());
    EXPECT_FALSE(step.struck(1.01).empty());
}

/// A dumbbell of two masses on the x axis, one metre from the middle each, and the two as pieces.
struct Dumbbell {
    Dumbbell() {
        whole.setCenterOfMassTransform(at(0, 0, 0));
        left.setCenterOfMassTransform(at(-1, 0, 0));
        right.setCenterOfMassTransform(at(1, 0, 0));
        for (btRigidBody* body : {&whole, &left, &right}) body->updateInertiaTensor();
    }
    btSphereShape shape{0.1f};
    btRigidBody whole{2, nullptr, &shape, btVector3(0.02f, 2.02f, 2.02f)};
    btRigidBody left{1, nullptr, &shape, btVector3(0.01f, 0.01f, 0.01f)};
    btRigidBody right{1, nullptr, &shape, btVector3(0.01f, 0.01f, 0.01f)};
};

/// What a ball does to a plate that it falls on; one that is a mesh, or a sphere of the app's.
double forceOfABall(bool is_mesh) {
    constexpr double radius = 0.05;
    Material material = crumbly();
    Settings settings = coarse(0.03);
    settings.fracture.contact.partner_youngs_modulus_pa = material.youngs_modulus_pa;
    settings.fracture.contact.partner_poisson_ratio = material.poisson_ratio;
    const auto target = BreakableAsset::fromMesh(shapes::box(Vec3(-0.3, -0.3, -0.03), Vec3(0.3, 0.3, 0.03)),
                                                 material, settings);
    const auto ball = BreakableAsset::fromMesh(shapes::icosphere(radius, 4), material, settings);
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    EXPECT_TRUE(fracture.setBudget(Budget::none()).ok());
    const btRigidBody* plate = fracture.add(target.value(), at(0, 0, 0)).value();
    const btVector3 place(0.02f, 0.03f, btScalar(0.03 + radius + 0.01)), velocity(0, 0, -3);
    if (is_mesh)
        fracture.add(ball.value(), at(place.x(), place.y(), place.z())).value()->setLinearVelocity(velocity);
    else
        scene.addBall(ball.value().mass(), radius, place, velocity);
    scene.step(4);
    for (const BlowEvent& event : fracture.takeEvents())
        if (event.body == plate) return event.peak_force_n;
    ADD_FAILURE() << "the plate was not struck";
    return 0;
}

/// A hull does not say how round it is. Taken for flat, the ball struck by a quarter harder.
TEST(Collector, ABreakableBallIsAsRoundAsItsSurface) {
    const double of_sphere = forceOfABall(false);
    EXPECT_NEAR(forceOfABall(true), of_sphere, 0.05 * of_sphere);
}

TEST(FragmentMotion, PiecesGoOnAsTheWholeDid) {
    Dumbbell d;
    d.whole.setLinearVelocity(btVector3(1, 2, 3));
    d.whole.setAngularVelocity(btVector3(0, 0, 4));
    shareMotion(d.whole, {&d.left, &d.right});
    EXPECT_LT(d.right.getLinearVelocity().distance(btVector3(1, 6, 3)), 1e-5);
    EXPECT_LT(d.left.getLinearVelocity().distance(btVector3(1, -2, 3)), 1e-5);
    EXPECT_LT(d.right.getAngularVelocity().distance(btVector3(0, 0, 4)), 1e-5);
    EXPECT_LT(momentumDifference(d.whole, {&d.left, &d.right}), 1e-6);
    d.left.setLinearVelocity(btVector3(1, -2, 3.1f));
    EXPECT_GT(momentumDifference(d.whole, {&d.left, &d.right}), 1e-3) << "the figure sees what is wrong";
}

TEST(FragmentMotion, MomentumIsKeptWhereTheAppsInertiaIsNotThatOfTheSolid) {
    Dumbbell d;
    d.whole.setMassProps(2, btVector3(1.01f, 1.01f, 1.01f));
    d.whole.updateInertiaTensor();
    d.whole.setAngularVelocity(btVector3(0, 0, 4));
    shareMotion(d.whole, {&d.left, &d.right});
    EXPECT_NEAR(d.right.getAngularVelocity().z(), 2, 1e-5) << "half the inertia: half the spin";
    EXPECT_LT(momentumDifference(d.whole, {&d.left, &d.right}), 1e-6);
}

TEST(FragmentMotion, NoEnergyComesOfAnInertiaThatIsTooLarge) {
    Dumbbell d;
    d.whole.setMassProps(2, btVector3(8, 8, 8));  // of a box around it, as Bullet has it for hulls
    d.whole.updateInertiaTensor();
    d.whole.setAngularVelocity(btVector3(0, 0, 4));
    shareMotion(d.whole, {&d.left, &d.right});
    EXPECT_EQ(d.right.getAngularVelocity(), btVector3(0, 0, 4)) << "as it turned, not four times as fast";
    EXPECT_LT(d.right.getLinearVelocity().distance(btVector3(0, 4, 0)), 1e-5);
    EXPECT_GT(momentumDifference(d.whole, {&d.left, &d.right}), 0.1) << "the figure says what was left out";
}

TEST(FragmentMotion, LockedAxesKeepTheirSpin) {
    Dumbbell d;
    d.whole.setMassProps(2, btVector3(0, 0, 0));
    d.whole.setAngularVelocity(btVector3(0, 0, 4));
    shareMotion(d.whole, {&d.left, &d.right});
    EXPECT_EQ(d.right.getAngularVelocity().z(), 4);
}

TEST(FragmentMotion, ForcesAreSharedAsTheAccelerationOfTheWhole) {
    Dumbbell d;
    d.whole.applyCentralForce(btVector3(4, 0, 0));
    d.whole.applyTorque(btVector3(0, 0, 2.02f));  // 1 rad/s^2
    shareForces(d.whole, {&d.left, &d.right}, true);
    EXPECT_LT(d.right.getTotalForce().distance(btVector3(2, 1, 0)), 1e-5);
    EXPECT_LT(d.left.getTotalForce().distance(btVector3(2, -1, 0)), 1e-5);
    EXPECT_NEAR(d.left.getTotalTorque().z(), 0.01, 1e-6);
}

TEST(FragmentMotion, PiecesOfABodyThatSleptGetTheGravityThatItWasNotGiven) {
    Dumbbell d;
    d.whole.setGravity(btVector3(0, 0, -10));
    shareForces(d.whole, {&d.left, &d.right}, true);
    EXPECT_LT(d.right.getTotalForce().distance(btVector3(0, 0, -10)), 1e-5);
}

}  // namespace
