// Bodies squeezed between a striker and what they stand on or lean against: the load goes through, and all of
// a column hears of it, at any rate of steps.
//
// Closed form: a strike that lasts long against the swings of the column is stored by springs in series, a
// Hertz contact (Johnson 1985, 4.2) and rods between it and a floor that does not give way,
// 1/2 m v^2 = 2/5 F d(F) + F^2 n h / (2 E A), and every section carries F.

#include <cmath>

#include "bullet/strikes/contact_collector.h"
#include "bullet/support.h"
#include "fracture/blow_stress.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

constexpr double side = 0.12, height = 0.065, area = side * side;
constexpr double head = 0.03, hammer_kg = 5;

const BreakableAsset& brick() {
    static const auto made = BreakableAsset::fromMesh(shapes::slab(Vec3(side, side, height), 4, 4, 2),
                                                      Material::brick(), Settings{});
    return made.value();
}

double closedForm(int bricks, double speed) {
    const Material m = Material::brick();
    const double modulus = contactModulus(m.youngs_modulus_pa, m.poisson_ratio, 5e10, 0.25);
    const double hertz = hertzPeakForce({head, modulus}, hammer_kg, speed);
    return contactPulse({hammer_kg, speed, hertz}, bricks * height / (2 * m.youngs_modulus_pa * area), 0)
        .peak_force_n;
}

/// What bodies hear of the step in which a hammer with a rounded head strikes.
struct Scene {
    explicit Scene(double its_rate) : rate(its_rate) {
        scene.addFloor();
        scene.world->setGravity(btVector3(0, 0, btScalar(-9.81)));
    }
    void addBrick(const btTransform& place) {
        const double mass = brick().mass();
        btRigidBody* body =
            scene.addBox(btScalar(mass), btVector3(side / 2, side / 2, height / 2), place.getOrigin());
        body->setWorldTransform(place);
        auto breakable =
            std::make_unique<Breakable>(brick(), fractureSettingsFor(brick(), brick().settings().fracture));
        breakable->body = body;
        breakable->least_energy_j = least_energy_j;
        registry.add(std::move(breakable));
        bricks.push_back(body);
    }
    void settle() { scene.step(static_cast<int>(rate / 4), 1 / rate); }
    void strike(const btVector3& from, const btVector3& velocity) {
        btRigidBody* hammer = scene.addBall(hammer_kg, head, from, velocity);
        hammer->setGravity(btVector3(0, 0, 0));
        listen();
    }
    void listen() {
        before.take(*scene.world);
        scene.step(1, 1 / rate);
        ContactCollector collector(registry, before, 0, scene.world->getSolverInfo());
        feedSolvedContacts(*scene.world, collector);
        struck = collector.takeStruck();
    }
    /// Of the side that a push comes from, and of the other, N; zero if the body hears of nothing.
    struct Forces {
        double from = 0, against = 0;
    };
    Forces forces(std::size_t number, const Vec3& push) const {
        Forces found;
        const BreakableSolid& solid = *brick().solid();
        for (const StruckBreakable& one : struck) {
            if (one.breakable->body != bricks[number]) continue;
            StageTimes ms;
            const auto stress = blowStress(
                {solid, *solid.discretisation().value(), solid.settings().fracture, 1}, one.blow, ms);
            EXPECT_TRUE(stress.ok()) << stress.error();
            for (const PointForce& load : stress.value().loads) {
                const double along = stress.value().pulse.peak_force_n * load.force.dot(push);
                (along > 0 ? found.from : found.against) += std::abs(along);
            }
        }
        return found;
    }

    double rate, least_energy_j = 0;
    TestWorld scene;
    BreakableRegistry registry;
    StepSnapshot before;
    std::vector<btRigidBody*> bricks;
    std::vector<StruckBreakable> struck;
};

TEST(Squeezed, ABrickOnTheFloorAndAColumnCarryTheForceOfTheStrikeToTheFloor) {
    const double speed = 0.5;
    for (const double rate : {60.0, 120.0, 240.0, 960.0})
        for (const int count : {1, 3, 5}) {
            Scene column(rate);
            for (int i = 0; i < count; ++i) column.addBrick(at(0, 0, btScalar((i + 0.5) * height)));
            column.settle();
            const double top = column.bricks.back()->getWorldTransform().getOrigin().z() + height / 2;
            column.strike(btVector3(0, 0, btScalar(top + head + 1e-4)), btVector3(0, 0, btScalar(-speed)));
            const double force = closedForm(count, speed);
            std::printf("%d bricks, %g Hz, closed form %.0f N:", count, rate, force);
            for (int i = count - 1; i >= 0; --i) {
                const auto [through, foot] = column.forces(i, -Vec3::UnitZ());
                std::printf(" %.0f/%.0f", through, foot);
                EXPECT_NEAR(through / force, 1, 0.05) << rate << " Hz, brick " << i << " of " << count;
                EXPECT_NEAR(foot / force, 1, 0.05) << rate << " Hz, brick " << i << " of " << count;
            }
            std::puts(" N");
        }
}

TEST(Squeezed, ABrickThatLeansOnAWallIsPressedAgainstIt) {
    const double speed = 0.5;
    const btTransform upright(btQuaternion(btVector3(0, 1, 0), SIMD_HALF_PI), btVector3(0, 0, side / 2));
    for (const double rate : {60.0, 120.0, 240.0, 960.0}) {
        Scene scene(rate);
        scene.scene.addBox(0, btVector3(0.1f, 0.5f, 0.5f), btVector3(height / 2 + 0.1f, 0, 0.5f));
        scene.addBrick(upright);
        scene.settle();
        const double face = scene.bricks[0]->getWorldTransform().getOrigin().x() - height / 2;
        scene.strike(btVector3(btScalar(face - head - 1e-4), 0, side / 2), btVector3(btScalar(speed), 0, 0));
        const auto [through, wall] = scene.forces(0, Vec3::UnitZ());  // of the asset
        const double force = closedForm(1, speed);
        std::printf("%g Hz: %.0f N, at the wall %.0f N, closed form %.0f N\n", rate, through, wall, force);
        EXPECT_NEAR(through / force, 1, 0.05) << rate << " Hz";
        EXPECT_NEAR(wall / force, 1, 0.05) << rate << " Hz";
    }
}

/// A column of three, of which one is weak.
TEST(Squeezed, TheWeakestBrickOfAColumnBreaksWhereverItStands) {
    for (const double rate : {60.0, 960.0})
        for (const int weak : {0, 1, 2}) {
            TestWorld scene;
            scene.addFloor();
            scene.world->setGravity(btVector3(0, 0, btScalar(-9.81)));
            FractureWorld fracture(scene.world.get());
            std::vector<btRigidBody*> bricks;
            for (int i = 0; i < 3; ++i) {
                Material material = Material::brick();
                material.tensile_strength_pa = i == weak ? 1e4 : 3e7;
                material.compressive_strength_pa = 1e10;
                material.fracture_energy_j_m2 = 0.1;
                const auto asset = BreakableAsset::fromMesh(shapes::slab(Vec3(side, side, height), 4, 4, 2),
                                                            material, Settings::forQuality(Quality::preview));
                ASSERT_TRUE(asset.ok()) << asset.error();
                bricks.push_back(fracture.add(asset.value(), at(0, 0, btScalar((i + 0.5) * height))).value());
            }
            scene.step(static_cast<int>(rate), 1 / rate);
            const double top = bricks[2]->getWorldTransform().getOrigin().z() + height / 2;
            scene.addBall(hammer_kg, head, btVector3(0, 0, btScalar(top + head + 1e-4)), btVector3(0, 0, -1));
            fracture.takeEvents();
            scene.step(1, 1 / rate);
            std::vector<int> heard(3);
            for (const BlowEvent& event : fracture.takeEvents())
                for (int i = 0; i < 3; ++i) {
                    if (event.body != bricks[i]) continue;
                    ++heard[i];
                    EXPECT_EQ(event.outcome == Outcome::broke, i == weak) << i << " of weak " << weak;
                }
            EXPECT_EQ(heard, std::vector<int>(3, 1)) << rate << " Hz, weak " << weak;
        }
}

/// The closing speed and the striker of what a brick on a tray hears when that comes down at `speed`, with
/// crates between them, on the floor or on a table top that stands on it.
struct OnATray {
    OnATray(double rate, btScalar speed, int crates = 0, bool is_table = false) : scene(rate) {
        scene.scene.world->setGravity(btVector3(0, 0, 0));
        const btScalar thick = 0.02f, in = 1e-4f;
        btScalar top = -in;
        if (is_table) {
            scene.scene.addBox(50, btVector3(0.5f, 0.5f, 0.05f), btVector3(0, 0, 0.05f - in));
            top += 0.1f - in;
        }
        for (int i = 0; i <= crates; ++i, top += thick - in) {
            tray = scene.scene.addBox(3, btVector3(0.2f, 0.2f, thick / 2), btVector3(0, 0, top + thick / 2));
            tray->setLinearVelocity(btVector3(0, 0, -speed));
        }
        scene.addBrick(at(0, 0, top + btScalar(height / 2)));
        scene.bricks[0]->setLinearVelocity(btVector3(0, 0, -speed));
        scene.listen();
        for (const StruckBreakable& one : scene.struck)
            for (const ContactImpulse& contact : one.blow.contacts)
                closing_m_s = std::max(closing_m_s, contact.approach_m_s);
    }
    Scene scene;
    btRigidBody* tray = nullptr;  // the uppermost
    double closing_m_s = 0;
};

TEST(Squeezed, WhatRestsOnATrayStrikesItWhenThatLands) {
    for (const double rate : {60.0, 120.0, 240.0, 960.0})
        for (const bool is_table : {false, true})
            for (const int crates : {0, 1}) {
                const OnATray landed(rate, 3, crates, is_table);
                ASSERT_EQ(landed.scene.struck.size(), 1u) << rate << " Hz, " << crates;
                EXPECT_EQ(landed.scene.struck[0].striker, landed.tray);
                EXPECT_NEAR(landed.closing_m_s, 3, 0.5) << rate << " Hz, " << crates;
                EXPECT_EQ(OnATray(rate, 0, crates, is_table).closing_m_s, 0) << "it stands";
            }
}

// What touches the lower brick faintly in the same step does not hide from it what comes through the upper.
TEST(Squeezed, ATrifleDoesNotHideTheLoadThatGoesThrough) {
    const auto pressed = [](bool with_pea) {
        Scene column(240);
        column.least_energy_j = 1e-3;  // the ball brings 5e-5, the hammer 0.6
        for (int i = 0; i < 2; ++i) column.addBrick(at(0, 0, btScalar(height * (i + 0.5))));
        column.settle();
        if (with_pea)
            column.scene.addBall(1e-4, 0.005,
                                 btVector3(btScalar(side / 2) + 0.0051f, 0, btScalar(height / 2)),
                                 btVector3(-1, 0, 0));
        const double top = column.bricks.back()->getWorldTransform().getOrigin().z() + height / 2;
        column.strike(btVector3(0, 0, btScalar(top + head + 1e-4)), btVector3(0, 0, -0.5f));
        return column.forces(0, -Vec3::UnitZ()).from;
    };
    const double alone = pressed(false);
    EXPECT_GT(alone, 1000);
    EXPECT_NEAR(pressed(true), alone, 0.05 * alone);
}

}  // namespace
