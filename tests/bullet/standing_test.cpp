// Blows on bodies that stand on something, and blows by bodies that are pushed: neither weight nor the time
// step nor a force of the app's changes what a strike does.

#include <cmath>

#include "bullet/strikes/contact_collector.h"
#include "bullet/support.h"
#include "fracture/blow_stress.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

constexpr double rates[] = {60, 120, 240, 960};

/// Bears what these tests do to it, and is solved all the same.
Material strongPlaster() {
    Material material = Material::plaster();
    material.tensile_strength_pa = 50e6;
    return material;
}

/// The first solved blow on a plaster wall of 1 x 0.09 x 1 m that a steel ball of 0.88 kg strikes in its
/// middle at 8 m/s.
BlowEvent blowOnWall(bool stands, double rate, double settled_s = 0) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    static const auto asset = BreakableAsset::fromMesh(
        shapes::box(Vec3(-0.5, -0.045, -0.5), Vec3(0.5, 0.045, 0.5), 8, 1, 8), strongPlaster());
    EXPECT_TRUE(asset.ok()) << asset.error();
    if (stands) scene.addFloor();
    if (stands) scene.world->setGravity(btVector3(0, 0, btScalar(-9.81)));
    EXPECT_TRUE(fracture.add(asset.value(), at(0, 0, 0.5f)));
    scene.step(static_cast<int>(settled_s * rate), 1 / rate);
    btRigidBody* ball = scene.addBall(0.882, 0.03, btVector3(0, -0.08f, 0.5f), btVector3(0, 8, 0));
    ball->setCcdMotionThreshold(0.015f);
    ball->setCcdSweptSphereRadius(0.015f);
    for (int i = 0; i < 30; ++i) {
        scene.step(1, 1 / rate);
        for (BlowEvent& event : fracture.takeEvents()) return event;
    }
    ADD_FAILURE() << "no blow was solved at " << rate << " Hz";
    return noBreak();
}

TEST(Standing, AWallStruckInItsMiddleIsStressedAsOneThatFloats) {
    for (const double settled_s : {0.0, 0.5})
        for (const double rate : rates) {
            const double floats = blowOnWall(false, rate).largest_stress_pa;
            const double stands = blowOnWall(true, rate, settled_s).largest_stress_pa;
            std::printf("%g Hz: floating %.3f MPa, standing %.3f MPa\n", rate, floats / 1e6, stands / 1e6);
            EXPECT_NEAR(stands / floats, 1, 0.03) << rate << " Hz, settled for " << settled_s << " s";
        }
}

/// The blow of a body that lands on a floor at 5 m/s, tilted by that much, when it is `left_m` above it at
/// the end of a step.
BlowEvent landing(const BreakableAsset& asset, double half_height_m, double tilt_rad, double rate,
                  double left_m) {
    constexpr double speed_m_s = 5;
    TestWorld scene;
    scene.addFloor();
    FractureWorld fracture(scene.world.get());
    BodyOptions options;
    options.start = at(0, 0, btScalar(half_height_m + 0.1 * std::sin(tilt_rad) + left_m + speed_m_s / rate));
    options.start.setRotation(btQuaternion(btVector3(0, 1, 0), btScalar(tilt_rad)));
    options.velocity = btVector3(0, 0, btScalar(-speed_m_s));
    EXPECT_TRUE(fracture.add(asset, options).ok());
    for (int i = 0; i < 4; ++i) {
        scene.step(1, 1 / rate);
        for (BlowEvent& event : fracture.takeEvents()) return event;
    }
    ADD_FAILURE() << "no blow was solved at " << rate << " Hz, " << left_m << " m above the floor";
    return noBreak();
}

// Where a body lands on several points it strikes with those that it meets at about the same time, whether
// Bullet has it above the floor or in it by the end of the step.
TEST(Landing, FlatOrAlmostFlatIsTheSameAtAllRatesAndPhases) {
    const Mat3 lying(Eigen::AngleAxisd(1.5707963267948966, Vec3::UnitY()));
    const auto jar = [&](const std::vector<std::pair<double, double>>& profile) {
        return shapes::moved(shapes::revolvedSolid(profile, 48), lying);
    };
    struct Body {
        TriangleMesh mesh;
        double half_height_m;
        std::vector<double> tilts_rad;
    };
    const Body bodies[] = {
        {shapes::box(Vec3(-0.1, -0.03, -0.02), Vec3(0.1, 0.03, 0.02), 10, 3, 2), 0.02, {0, 1e-3, 3e-3}},
        {jar({{0.04, -0.1}, {0.04, 0.1}}), 0.04, {0, 1e-3, 3e-3}},
        {jar({{0.03, -0.1}, {0.04, -0.05}, {0.04, 0.05}, {0.03, 0.1}}), 0.04, {0, 3.5e-3, 0.01}}};
    const Settings settings = Settings::forQuality(Quality::preview);
    for (const Body& body : bodies) {
        const auto asset = BreakableAsset::fromMesh(body.mesh, Material::ceramic(), settings);
        ASSERT_TRUE(asset.ok()) << asset.error();
        for (const double tilt_rad : body.tilts_rad) {
            const BlowEvent reference = landing(asset.value(), body.half_height_m, tilt_rad, 960, -0.003);
            for (const double rate : rates)
                for (const double left_m : {0.0015, 0.0005, -0.0002, -0.003, -0.01, -0.023, -0.04}) {
                    if (left_m < -5 / rate) continue;
                    const BlowEvent event =
                        landing(asset.value(), body.half_height_m, tilt_rad, rate, left_m);
                    EXPECT_NEAR(event.peak_force_n / reference.peak_force_n, 1, 0.02)
                        << tilt_rad << " rad, " << rate << " Hz, " << left_m << " m";
                    EXPECT_NEAR(event.largest_stress_pa / reference.largest_stress_pa, 1, 0.05);
                }
        }
    }
}

/// The blow of a body that flies towards a floor at 3 m/s and spins. The floor is a box, unless it is given.
BlowEvent spinningLanding(const BreakableAsset& asset, const btVector3& spin, double height_m, double rate,
                          std::unique_ptr<btCollisionShape> floor = nullptr) {
    TestWorld scene;
    if (floor)
        scene.addBody(std::move(floor), 0, btVector3(0, 0, 0));
    else
        scene.addFloor();
    FractureWorld fracture(scene.world.get());
    BodyOptions options;
    options.start = at(0, 0, btScalar(height_m));
    options.start.setRotation(btQuaternion(btVector3(1, 1, 0).normalized(), 0.2f));
    options.velocity = btVector3(0, 0, -3);
    options.angular_velocity = spin;
    const btRigidBody* body = fracture.add(asset, options).value();
    EXPECT_TRUE(body);
    for (int i = 0; i < 0.5 * rate; ++i) {
        scene.step(1, 1 / rate);
        for (BlowEvent& event : fracture.takeEvents()) return event;
    }
    ADD_FAILURE() << "no blow was solved at " << rate << " Hz from " << height_m << " m";
    return noBreak();
}

// At 60 steps a second a body that turns by 10 rad/s is found up to 10 degrees beyond how it touched.
TEST(Landing, SpinningIsTheSameAtAllRatesAndPhases) {
    const Settings settings = Settings::forQuality(Quality::preview);
    struct Body {
        TriangleMesh mesh;
        btVector3 spin;
    };
    const Body bodies[] = {
        {shapes::box(Vec3(-0.15, -0.15, -0.004), Vec3(0.15, 0.15, 0.004), 10, 10, 1), btVector3(10, 0, 0)},
        {shapes::box(Vec3(-0.3, -0.02, -0.02), Vec3(0.3, 0.02, 0.02), 20, 2, 2), btVector3(0, 10, 3)},
        {shapes::revolvedSolid({{0.05, -0.1}, {0.05, 0.1}}, 48), btVector3(10, 4, 0)}};
    for (const Body& body : bodies) {
        const auto asset = BreakableAsset::fromMesh(body.mesh, Material::ceramic(), settings);
        ASSERT_TRUE(asset.ok()) << asset.error();
        for (const double height_m : {0.25, 0.262, 0.281}) {
            const BlowEvent reference = spinningLanding(asset.value(), body.spin, height_m, 1920);
            for (const double rate : rates) {
                const BlowEvent event = spinningLanding(asset.value(), body.spin, height_m, rate);
                EXPECT_NEAR(event.peak_force_n / reference.peak_force_n, 1, 0.04)
                    << rate << " Hz, " << height_m << " m";
                EXPECT_NEAR(event.largest_stress_pa / reference.largest_stress_pa, 1, 0.1)
                    << rate << " Hz, " << height_m << " m";
                EXPECT_LT((event.normal - Vec3::UnitZ()).norm(), 1e-3) << "that of the floor";
            }
        }
    }
}

TEST(Landing, SpinningOnAPlaneOrAMeshIsAsOnABox) {
    const auto asset =
        BreakableAsset::fromMesh(shapes::box(Vec3(-0.15, -0.15, -0.004), Vec3(0.15, 0.15, 0.004), 10, 10, 1),
                                 Material::ceramic(), Settings::forQuality(Quality::preview));
    ASSERT_TRUE(asset.ok()) << asset.error();
    btTriangleMesh triangles;
    const btVector3 corners[] = {{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}};
    triangles.addTriangle(corners[0], corners[1], corners[2]);
    triangles.addTriangle(corners[0], corners[2], corners[3]);
    const btVector3 spin(10, 0, 0);
    for (const double height_m : {0.25, 0.262, 0.281}) {
        const BlowEvent reference = spinningLanding(asset.value(), spin, height_m, 1920);
        for (const bool is_mesh : {false, true}) {
            std::unique_ptr<btCollisionShape> floor;
            if (is_mesh)
                floor = std::make_unique<btBvhTriangleMeshShape>(&triangles, true);
            else
                floor = std::make_unique<btStaticPlaneShape>(btVector3(0, 0, 1), btScalar(0));
            const BlowEvent event = spinningLanding(asset.value(), spin, height_m, 60, std::move(floor));
            EXPECT_NEAR(event.peak_force_n / reference.peak_force_n, 1, 0.04) << is_mesh << ' ' << height_m;
            EXPECT_LT((event.normal - Vec3::UnitZ()).norm(), 1e-3) << is_mesh << ' ' << height_m;
        }
    }
}

// A step takes it up to 5 cm in, with hundreds of its vertices.
TEST(Landing, DeepIsAsShallowWhereManyVerticesAreBelow) {
    const auto asset = BreakableAsset::fromMesh(shapes::cup(0.036, 0.2, 0.004, 128, 40), Material::glass());
    ASSERT_TRUE(asset.ok()) << asset.error();
    for (const double height_m : {0.25, 0.262, 0.281, 0.295}) {
        const BlowEvent reference = spinningLanding(asset.value(), btVector3(0, 0, 0), height_m, 1920),
                        deep = spinningLanding(asset.value(), btVector3(0, 0, 0), height_m, 60);
        EXPECT_NEAR(deep.peak_force_n / reference.peak_force_n, 1, 0.02) << height_m;
    }
}

// In a step of 1/60 s gravity gives a body 0.16 m/s, and what rests may come back with twice that.
TEST(Standing, WhatIsHeavyAndSetDownSlowlyStrikesAtAllRates) {
    const auto pane =
        BreakableAsset::fromMesh(shapes::box(Vec3(-0.5, -0.4, -0.003), Vec3(0.5, 0.4, 0.003), 10, 8, 1),
                                 Material::glass(), Settings::forQuality(Quality::preview));
    ASSERT_TRUE(pane.ok()) << pane.error();
    std::vector<double> stress_pa;
    for (const double& rate : rates) {
        TestWorld scene;
        for (const btScalar side : {-1.0f, 1.0f})
            scene.addBox(0, btVector3(0.01f, 0.5f, 0.05f), btVector3(0.48f * side, 0, -0.053f));
        FractureWorld fracture(scene.world.get());
        ASSERT_TRUE(fracture.add(pane.value(), at(0, 0, 0)).ok());
        for (btRigidBody* body : fracture.bodies()) body->setGravity(btVector3(0, 0, btScalar(-9.81)));
        scene.step(static_cast<int>(rate / 4), 1 / rate);
        EXPECT_TRUE(fracture.takeEvents().empty()) << "at rest";
        scene.addBall(500, 0.1, btVector3(0, 0, 0.104f), btVector3(0, 0, -0.3f));
        for (int i = 0; i < rate / 4 && stress_pa.size() == std::size_t(&rate - rates); ++i) {
            scene.step(1, 1 / rate);
            for (const BlowEvent& event : fracture.takeEvents()) {
                EXPECT_EQ(event.outcome, Outcome::broke) << rate;
                stress_pa.push_back(event.largest_stress_pa);
                break;
            }
        }
        ASSERT_EQ(stress_pa.size(), std::size_t(&rate - rates) + 1) << rate;
    }
    for (const double stress : stress_pa) EXPECT_NEAR(stress / stress_pa.back(), 1, 0.05);
}

/// The first solved blow of a ball of 5 kg that touches a plate at 8 m/s with a force behind it; outcome
/// `held` and no stress if none was solved.
BlowEvent blowOfPushedBall(double force_n, double rate) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    btRigidBody* struck = scene.addBox(25, btVector3(0.3f, 0.3f, 0.03f), btVector3(0, 0, 0));
    EXPECT_TRUE(fracture.makeBreakable(struck, strongPlaster(), coarse(0.06)));
    btRigidBody* ball = scene.addBall(5, 0.1, btVector3(0, 0, 0.1305f), btVector3(0, 0, -8));
    for (int i = 0; i < 20; ++i) {
        ball->applyCentralForce(btVector3(0, 0, btScalar(-force_n)));
        scene.step(1, 1 / rate);
        for (BlowEvent& event : fracture.takeEvents()) return event;
    }
    ADD_FAILURE() << "no blow was solved at " << rate << " Hz with " << force_n << " N";
    return noBreak();
}

TEST(Standing, APushedStrikerStrikesAsAFreeOneDoes) {
    for (const double rate : rates) {
        const BlowEvent free = blowOfPushedBall(0, rate);
        for (const double force_n : {-500.0, 500.0, 1500.0, 15000.0}) {
            const BlowEvent pushed = blowOfPushedBall(force_n, rate);
            std::printf("%g Hz, %g N: %.3f MPa, free %.3f MPa\n", rate, force_n,
                        pushed.largest_stress_pa / 1e6, free.largest_stress_pa / 1e6);
            EXPECT_NEAR(pushed.largest_stress_pa / free.largest_stress_pa, 1, 0.01)
                << rate << " Hz, " << force_n;
        }
    }
}

TEST(Standing, ABodyThatIsPushedAgainstAWallRests) {
    for (const double rate : rates)
        for (const double force_n : {100.0, 1500.0}) {
            TestWorld scene;
            scene.addFloor();
            FractureWorld fracture(scene.world.get());
            btRigidBody* pushed = scene.addBox(5, btVector3(0.1f, 0.1f, 0.1f), btVector3(0, 0, 0.1f));
            ASSERT_TRUE(fracture.makeBreakable(pushed, crumbly(), coarse(0.1)));
            for (int i = 0; i < static_cast<int>(3 * rate); ++i) {
                pushed->activate();
                pushed->applyCentralForce(btVector3(0, 0, btScalar(-force_n)));
                scene.step(1, 1 / rate);
            }
            EXPECT_EQ(fracture.counts().solved(), 0) << rate << " Hz, " << force_n;
        }
}

/// A brick of 0.1 x 0.1 x 0.25 m that stands on its end, on a floor or on nothing, and the first blow on it
/// by a hammer of 1 kg with a rounded head of 3 cm, from above.
struct StruckBrick {
    StruckBrick(bool stands, double rate, double speed) {
        if (stands) scene.addFloor();
        if (stands) scene.world->setGravity(btVector3(0, 0, btScalar(-9.81)));
        btRigidBody* brick = scene.addBox(mass, btVector3(0.05f, 0.05f, 0.125f), btVector3(0, 0, 0.125f));
        auto breakable =
            std::make_unique<Breakable>(asset(), fractureSettingsFor(asset(), asset().settings().fracture));
        breakable->body = brick;
        registry.add(std::move(breakable));
        scene.step(static_cast<int>(rate / 4), 1 / rate);
        const double top = brick->getWorldTransform().getOrigin().z() + 0.125;
        btRigidBody* hammer = scene.addBall(1, head, btVector3(0, 0, btScalar(top + head + 1e-4)),
                                            btVector3(0, 0, btScalar(-speed)));
        hammer->setGravity(btVector3(0, 0, 0));
        before.take(*scene.world);
        scene.step(1, 1 / rate);
        ContactCollector collector(registry, before, 0, scene.world->getSolverInfo());
        feedSolvedContacts(*scene.world, collector);
        const auto struck = collector.takeStruck();
        EXPECT_EQ(struck.size(), 1u) << rate << " Hz";
        if (!struck.empty()) blow = struck[0].blow;
    }

    static const BreakableAsset& asset() {
        static const auto made = BreakableAsset::fromMesh(shapes::slab(Vec3(0.1, 0.1, 0.25), 4, 4, 10),
                                                          Material::brick(), Settings{});
        return made.value();
    }

    static constexpr double mass = 0.1 * 0.1 * 0.25 * 1800, head = 0.03;
    TestWorld scene;
    BreakableRegistry registry;
    StepSnapshot before;
    Blow blow;
};

/// Mean stress along z over the section at z, Pa.
double sectionStress(const BreakableSolid& brick, const BlowStress& stress, double z) {
    std::vector<Vec3> points;
    for (double x = -0.045; x < 0.05; x += 0.01)
        for (double y = -0.045; y < 0.05; y += 0.01) points.emplace_back(x, y, z);
    const auto field = brick.stressSolver().value()->solve(stress.loads, points);
    EXPECT_TRUE(field.ok()) << field.error();
    double sum = 0;
    for (const SymmetricTensor& s : field.value().points) sum += s[2];
    return stress.pulse.peak_force_n * sum / static_cast<double>(points.size());
}

// The strike of a hammer lasts long against the way of a wave through the brick and back: it squeezes the
// brick between hammer and floor. With the brick a rod between a Hertz contact (Johnson 1985, 4.2) and a
// floor that does not give way, 1/2 m v^2 = 2/5 F d(F) + F^2 h / (2 E A), and every section carries F / A. A
// brick that floats is stopped by its own inertia: sections carry the less the further they are from the
// hammer.
TEST(Standing, ABrickStruckFromAboveIsSqueezedOnAFloor) {
    const BreakableSolid& brick = *StruckBrick::asset().solid();
    const Material& m = brick.material();
    const double speed = 0.5, area = 0.01, height = 0.25;
    const double modulus = contactModulus(m.youngs_modulus_pa, m.poisson_ratio, 5e10, 0.25);
    const auto peakForce = [&](double mass, double rod_share) {
        const double hertz = hertzPeakForce({StruckBrick::head, modulus}, mass, speed);
        const double rod = rod_share * height / (2 * m.youngs_modulus_pa * area);
        return contactPulse({mass, speed, hertz}, rod, 0).peak_force_n;
    };
    // Inertia makes the force in a free rod fall off to nothing at its far end: a third of the energy.
    const double standing = peakForce(1, 1), floating = peakForce(1 / (1 + 1 / StruckBrick::mass), 1.0 / 3);
    for (const bool stands : {true, false})
        for (const double rate : rates) {
            const StruckBrick struck(stands, rate, speed);
            StageTimes ms;
            const auto stress = blowStress(
                {brick, *brick.discretisation().value(), brick.settings().fracture, 1}, struck.blow, ms);
            ASSERT_TRUE(stress.ok()) << stress.error();
            const double force = stands ? standing : floating;
            std::printf("%s, %g Hz: %.0f N, closed form %.0f N, %.3g s;", stands ? "standing" : "floating",
                        rate, stress.value().pulse.peak_force_n, force, stress.value().pulse.duration_s);
            for (const double z : {-0.0625, 0.0, 0.0625}) {
                const double share = stands ? 1 : 0.5 + z / height;
                const double found = sectionStress(brick, stress.value(), z);
                std::printf(" %.4f (%.4f)", found / 1e6, -force * share / area / 1e6);
                EXPECT_NEAR(found / (-force * share / area), 1, 0.05) << rate << " Hz, z = " << z;
            }
            std::printf(" MPa\n");
        }
}

/// With the stress of a few points under its corners a plate broke when it was put down from 1 cm.
TEST(Landing, FlatIsByAllOfTheFaceWhateverItsTriangles) {
    const auto stressOf = [](const TriangleMesh& mesh, Quality quality) {
        const auto asset = BreakableAsset::fromMesh(mesh, Material::ceramic(), Settings::forQuality(quality));
        EXPECT_TRUE(asset.ok()) << asset.error();
        TestWorld scene;
        scene.world->setGravity(btVector3(0, 0, btScalar(-9.81)));
        scene.addFloor();
        FractureWorld fracture(scene.world.get());
        EXPECT_TRUE(fracture.setBudget(Budget::none()).ok());
        BodyOptions options(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, btScalar(0.06))));
        options.velocity = btVector3(0, 0, btScalar(-1.2));
        EXPECT_TRUE(fracture.add(asset.value(), options).ok());
        for (int step = 0; step < 60; ++step) {
            scene.step();
            const auto events = fracture.takeEvents();
            if (events.empty()) continue;
            EXPECT_EQ(events.front().outcome, Outcome::held);
            return events.front().largest_stress_pa;
        }
        ADD_FAILURE() << "nothing was struck";
        return 0.0;
    };
    const Vec3 size(0.2, 0.2, 0.02);
    const double game = stressOf(shapes::slab(size, 1, 1, 1), Quality::game);
    EXPECT_NEAR(stressOf(shapes::slab(size, 8, 8, 1), Quality::game), game, 0.05 * game);
    EXPECT_NEAR(stressOf(shapes::slab(size, 1, 1, 1), Quality::preview), game, 0.05 * game);
    EXPECT_NEAR(stressOf(shapes::slab(size, 1, 1, 1), Quality::film), game, 0.05 * game);
}

}  // namespace
