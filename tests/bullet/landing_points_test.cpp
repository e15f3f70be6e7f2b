// Where whole bodies touch what they land on: with their own surface, whatever hulls stand for it.

#include <algorithm>
#include <cmath>

#include "bullet/support.h"
#include "core/numerics/pi.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

constexpr double radius = 0.12, thickness = 0.02;
constexpr int sides = 128;  // four times as many as the hull has

enum class Ground { box, plane, mesh };

/// Lands on its rim, with a corner of the rim down.
class DiscOnItsRim : public testing::TestWithParam<Ground> {
  protected:
    DiscOnItsRim()
        : disc_(BreakableAsset::fromMesh(cylinderMesh(radius, thickness, sides), Material::ceramic())) {
        EXPECT_TRUE(disc_.ok()) << disc_.error();
        const btVector3 a(-5, -5, 0), b(5, -5, 0), c(5, 5, 0), d(-5, 5, 0);
        triangles_.addTriangle(a, b, c);
        triangles_.addTriangle(a, c, d);
    }

    void addGround(TestWorld& scene) {
        switch (GetParam()) {
            case Ground::box:
                scene.addFloor();
                break;
            case Ground::plane:
                scene.addBody(std::make_unique<btStaticPlaneShape>(btVector3(0, 0, 1), btScalar(0)), 0,
                              btVector3(0, 0, 0));
                break;
            case Ground::mesh:
                scene.addBody(std::make_unique<btBvhTriangleMeshShape>(&triangles_, true), 0,
                              btVector3(0, 0, 0));
                break;
        }
    }

    /// `corner`: which one of the rim is down.
    BlowEvent landOn(int corner) {
        TestWorld scene;
        scene.world->setGravity(btVector3(0, 0, btScalar(-9.81)));
        addGround(scene);
        FractureWorld fracture(scene.world.get());
        EXPECT_TRUE(fracture.setBudget(Budget::none()).ok());
        const btQuaternion rim_down(btVector3(0, 1, 0), btScalar(pi / 2));
        const btQuaternion turned(btVector3(0, 0, 1), btScalar(-2 * pi * corner / sides));
        const BodyOptions options(btTransform(rim_down * turned, btVector3(0, 0, btScalar(radius + 0.3))));
        EXPECT_TRUE(fracture.add(disc_.value(), options).ok());
        for (int step = 0; step < 120; ++step) {
            scene.step();
            const auto events = fracture.takeEvents();
            if (!events.empty()) return events.front();
        }
        ADD_FAILURE() << "nothing was struck";
        return BlowEvent(disc_.value());
    }

    Result<BreakableAsset> disc_;
    btTriangleMesh triangles_;
};

/// The hull has an edge between every fourth corner of the rim: with the middle of one down, it touched with
/// both ends of it, 6 mm beside the corner that was down, and the stress was 0.63 of the others'.
TEST_P(DiscOnItsRim, TouchesWithTheCornerThatIsDown) {
    double least = 1e300, most = 0;
    for (int corner = 0; corner < 5; ++corner) {
        const BlowEvent event = landOn(corner);
        EXPECT_NEAR(event.position.y(), 0, 1e-3) << corner;
        least = std::min(least, event.largest_stress_pa);
        most = std::max(most, event.largest_stress_pa);
    }
    EXPECT_LT(most, 1.15 * least);
}

INSTANTIATE_TEST_SUITE_P(LandingPoints, DiscOnItsRim,
                         testing::Values(Ground::box, Ground::plane, Ground::mesh), [](const auto& info) {
                             return info.param == Ground::box     ? "Box"
                                    : info.param == Ground::plane ? "Plane"
                                                                  : "Mesh";
                         });

/// A table of a top and four legs, which is several hulls: each has a manifold of its own.
TEST(LandingPoints, TheImpulseIsThatOfAllPartsOfTheBody) {
    TriangleMesh table =
        shapes::rectilinear({-0.2, -0.16, 0.16, 0.2}, {-0.2, -0.16, 0.16, 0.2}, {0, 0.3, 0.34},
                            [](int i, int j, int k) { return k == 1 || (i != 1 && j != 1); });
    const auto asset = BreakableAsset::fromMesh(table, crumbly(), coarse(0.04));
    ASSERT_TRUE(asset.ok()) << asset.error();
    for (const bool is_plane : {false, true}) {
        TestWorld scene;
        if (is_plane)
            scene.addBody(std::make_unique<btStaticPlaneShape>(btVector3(0, 0, 1), btScalar(0)), 0,
                          btVector3(0, 0, 0));
        else
            scene.addFloor();
        FractureWorld fracture(scene.world.get());
        EXPECT_TRUE(fracture.setBudget(Budget::none()).ok());
        btRigidBody* body = fracture.add(asset.value(), at(0, 0, 0.01f)).value();
        ASSERT_TRUE(body->getCollisionShape()->isCompound());
        body->setLinearVelocity(btVector3(0, 0, -4));
        scene.step(6);
        const auto events = fracture.takeEvents();
        ASSERT_FALSE(events.empty());
        const double brought = 4 * asset.value().mass();
        EXPECT_NEAR(events.front().impulse_n_s, brought, 0.1 * brought);
    }
}

/// The inner corners of legs are no vertices of the body's hull: on the outer ones alone a level table had
/// 2.7 times this stress, nearly that of one that comes down on two legs.
TEST(LandingPoints, LegsPressWithAllOfTheirCorners) {
    const TriangleMesh table =
        shapes::rectilinear({-0.2, -0.16, 0.16, 0.2}, {-0.2, -0.16, 0.16, 0.2}, {0, 0.3, 0.34},
                            [](int i, int j, int k) { return k == 1 || (i != 1 && j != 1); });
    const auto asset = BreakableAsset::fromMesh(table, Material::glass());
    ASSERT_TRUE(asset.ok()) << asset.error();
    const auto stressAt = [&](double tilt) {
        TestWorld scene;
        scene.addBody(std::make_unique<btStaticPlaneShape>(btVector3(0, 0, 1), btScalar(0)), 0,
                      btVector3(0, 0, 0));
        FractureWorld fracture(scene.world.get());
        EXPECT_TRUE(fracture.setBudget(Budget::none()).ok());
        const btQuaternion turn(btVector3(0, 1, 0), btScalar(tilt));
        const BodyOptions options(btTransform(turn, btVector3(0, 0, btScalar(0.01 + 0.2 * tilt))));
        fracture.add(asset.value(), options).value()->setLinearVelocity(btVector3(0, 0, -1));
        for (int step = 0; step < 12; ++step) {
            scene.step();
            const auto events = fracture.takeEvents();
            if (!events.empty()) return events.front().largest_stress_pa;
        }
        return 0.;
    };
    const double level = stressAt(0);
    EXPECT_GT(level, 0);
    EXPECT_LT(level, 0.6 * stressAt(5e-4)) << "on two legs";
}

/// Split impulses move a box while the step is solved, where the body is more than 4 cm deep in it.
TEST(LandingPoints, ABoxThatGivesWayIsStruckWhereItWas) {
    const auto disc = BreakableAsset::fromMesh(cylinderMesh(radius, 0.1, 64), Material::ceramic());
    ASSERT_TRUE(disc.ok()) << disc.error();
    std::vector<double> stresses;
    for (const bool split : {false, true}) {
        TestWorld scene;
        scene.world->getSolverInfo().m_splitImpulse = split;
        scene.addBox(20, btVector3(0.6f, 0.6f, 0.15f), btVector3(0, 0, -0.15f));
        FractureWorld fracture(scene.world.get());
        EXPECT_TRUE(fracture.setBudget(Budget::none()).ok());
        btRigidBody* body = fracture.add(disc.value(), at(0.4f, 0, 0.1f)).value();
        body->setLinearVelocity(btVector3(0, 0, -6));
        scene.step(3, 1.0 / 60);
        const auto events = fracture.takeEvents();
        ASSERT_FALSE(events.empty());
        stresses.push_back(events.front().largest_stress_pa);
    }
    EXPECT_NEAR(stresses[1], stresses[0], 0.02 * stresses[0]);
}

/// Something that a body is put down on, whose upper face is z = 0.
enum class Table { box, hull, round, moved, heavy, heavy_hull, heavy_breakable };

btRigidBody* addTable(TestWorld& scene, Table table) {
    constexpr btScalar half = btScalar(0.4), half_height = btScalar(0.2), margin = btScalar(0.04);
    constexpr double heavy_kg = 2000;
    const btVector3 middle(0, 0, -half_height), halves(half, half, half_height);
    const auto hull = [&] {
        auto shape = std::make_unique<btConvexHullShape>();
        for (int i = 0; i < 8; ++i)
            shape->addPoint({(i & 1) ? half : -half, (i & 2) ? half : -half,
                             ((i & 4) ? 1 : -1) * (half_height - margin)});
        shape->setMargin(margin);
        return shape;
    };
    switch (table) {
        case Table::box:
            return scene.addBox(0, halves, middle);
        case Table::hull:
            return scene.addBody(hull(), 0, middle);
        case Table::round:
            return scene.addBody(std::make_unique<btCylinderShapeZ>(halves), 0, middle);
        case Table::moved: {
            btRigidBody* body = scene.addBox(0, halves, middle);
            body->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
            return body;
        }
        case Table::heavy:
        case Table::heavy_breakable:
            return scene.addBox(heavy_kg, halves, middle);
        case Table::heavy_hull:
            return scene.addBody(hull(), heavy_kg, middle);
    }
    return nullptr;
}

/// A glass with a foot that is a ring, and a brick, whose shape is a box. On a hull and on what moves they
/// touched in one to four points, with up to a hundred times the stress.
TEST(LandingPoints, AFootIsPressedAlikeOnAllTables) {
    const auto glass = BreakableAsset::fromMesh(
        shapes::revolvedSolid({{0.04, 0}, {0.04, 0.1}, {0.036, 0.1}, {0.036, 0.01}}, 32), Material::glass());
    const auto brick = BreakableAsset::fromMesh(shapes::slab(Vec3(0.2, 0.1, 0.06)), Material::plaster());
    for (const auto& asset : {glass, brick}) {
        ASSERT_TRUE(asset.ok()) << asset.error();
        std::vector<double> stresses;
        for (const Table table : {Table::box, Table::hull, Table::round, Table::moved, Table::heavy,
                                  Table::heavy_hull, Table::heavy_breakable}) {
            TestWorld scene;
            btRigidBody* below = addTable(scene, table);
            FractureWorld fracture(scene.world.get());
            EXPECT_TRUE(fracture.setBudget(Budget::none()).ok());
            if (table == Table::heavy_breakable) {
                EXPECT_TRUE(fracture.makeBreakable(below, Material::concrete()).ok());
            }
            const double half_height = asset.value().surface().vertices.front().z() < 0 ? 0.03 : 0;
            btRigidBody* body =
                fracture.add(asset.value(), at(0.05f, 0.03f, float(half_height + 0.01))).value();
            body->setLinearVelocity(btVector3(0, 0, btScalar(-1)));
            scene.step(10);
            double stress = 0;
            for (const BlowEvent& event : fracture.takeEvents())
                if (event.asset.mass() == asset.value().mass())
                    stress = std::max(stress, event.largest_stress_pa);
            EXPECT_GT(stress, 0) << static_cast<int>(table);
            stresses.push_back(stress);
            EXPECT_NEAR(stress, stresses.front(), 0.1 * stresses.front()) << static_cast<int>(table);
        }
    }
}

/// Bullet stops what is about to land in two steps, by as much as leaves it no time to sink in, and turns it
/// as it does: what was left came down on a corner, with up to forty times the stress.
TEST(LandingPoints, ALandingIsOneBlowWhereverInAStepItComes) {
    const auto glass = BreakableAsset::fromMesh(
        shapes::revolvedSolid({{0.04, 0}, {0.04, 0.1}, {0.036, 0.1}, {0.036, 0.01}}, 32), Material::glass());
    ASSERT_TRUE(glass.ok()) << glass.error();
    constexpr double dt = 1.0 / 240, speed = 0.5;
    for (const bool is_plane : {true, false}) {
        double least = 1e300, most = 0;
        for (double part = 0; part < 1; part += 0.125) {
            TestWorld scene;
            if (is_plane)
                scene.addBody(std::make_unique<btStaticPlaneShape>(btVector3(0, 0, 1), btScalar(0)), 0,
                              btVector3(0, 0, 0));
            else
                addTable(scene, Table::hull);
            FractureWorld fracture(scene.world.get());
            EXPECT_TRUE(fracture.setBudget(Budget::none()).ok());
            btRigidBody* body =
                fracture.add(glass.value(), at(0, 0, float(0.01 + part * speed * dt))).value();
            body->setLinearVelocity(btVector3(0, 0, btScalar(-speed)));
            scene.step(20, dt);
            double stress = 0;
            for (const BlowEvent& event : fracture.takeEvents())
                stress = std::max(stress, event.largest_stress_pa);
            least = std::min(least, stress);
            most = std::max(most, stress);
        }
        EXPECT_GT(least, 0);
        EXPECT_LT(most, 1.2 * least) << is_plane;
    }
}

/// Holds what these tests do to it, and says so.
Material strongPlaster() {
    Material strong = Material::plaster();
    strong.tensile_strength_pa = 2e8;
    strong.fracture_energy_j_m2 = 1e-3;
    return strong;
}

/// The same ball on the same spot, thrown anew before each step.
TEST(LandingPoints, EachOfManyStrikesOnOneSpotIsABlow) {
    const auto plate = BreakableAsset::fromMesh(shapes::slab(Vec3(0.3, 0.3, 0.05)), strongPlaster());
    ASSERT_TRUE(plate.ok()) << plate.error();
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    EXPECT_TRUE(fracture.setBudget(Budget::none()).ok());
    btRigidBody* body = fracture.add(plate.value(), at(0, 0, 0)).value();
    btRigidBody* ball = scene.addBall(2, 0.05, btVector3(0, 0, 1));
    const btTransform start = body->getWorldTransform();
    constexpr int throws = 8;
    for (int step = 0; step < throws; ++step) {
        body->setWorldTransform(start);
        body->setLinearVelocity(btVector3(0, 0, 0));
        body->setAngularVelocity(btVector3(0, 0, 0));
        ball->setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, 0.0749f)));
        ball->setLinearVelocity(btVector3(0, 0, -5));
        scene.step();
    }
    EXPECT_EQ(fracture.takeEvents().size(), throws);
}

/// Floor and wall are one body, as those of a level are, and the edge that meets both is at one spot.
TEST(LandingPoints, TheWallIsABlowOfItsOwn) {
    const auto brick = BreakableAsset::fromMesh(shapes::slab(Vec3(0.2, 0.1, 0.06)), strongPlaster());
    ASSERT_TRUE(brick.ok()) << brick.error();
    TestWorld scene;
    auto level = std::make_unique<btCompoundShape>();
    btBoxShape ground(btVector3(5, 5, 0.5f)), wall(btVector3(0.5f, 5, 5));
    level->addChildShape(at(0, 0, -0.5f), &ground);
    level->addChildShape(at(0.6f, 0, 0), &wall);
    scene.addBody(std::move(level), 0, btVector3(0, 0, 0));
    FractureWorld fracture(scene.world.get());
    EXPECT_TRUE(fracture.setBudget(Budget::none()).ok());
    constexpr float dt = 1.f / 240, speed = 3;
    // Down in the first step, at the wall in the second.
    btRigidBody* body =
        fracture.add(brick.value(), at(0 - 1.5f * speed * dt, 0, 0.03f + 0.5f * speed * dt)).value();
    body->setFriction(0);
    body->setLinearVelocity(btVector3(speed, 0, -speed));
    scene.step(3, dt);
    int down = 0, aside = 0;
    for (const BlowEvent& event : fracture.takeEvents()) {
        down += event.normal.z() > 0.9;
        aside += event.normal.x() < -0.9;
    }
    EXPECT_GT(down, 0);
    EXPECT_GT(aside, 0);
}

/// One end of a rod comes down, and some steps later the other one.
TEST(LandingPoints, TheOtherEndIsABlowOfItsOwn) {
    const auto rod = BreakableAsset::fromMesh(shapes::slab(Vec3(0.5, 0.04, 0.04)), strongPlaster());
    ASSERT_TRUE(rod.ok()) << rod.error();
    TestWorld scene;
    scene.world->setGravity(btVector3(0, 0, btScalar(-9.81)));
    scene.addFloor();
    FractureWorld fracture(scene.world.get());
    EXPECT_TRUE(fracture.setBudget(Budget::none()).ok());
    BodyOptions options(btTransform(btQuaternion(btVector3(0, 1, 0), btScalar(0.05)), btVector3(0, 0, 0.4f)));
    options.velocity = btVector3(0, 0, -3);
    btRigidBody* body = fracture.add(rod.value(), options).value();
    std::vector<double> ends;
    for (int step = 0; step < 120; ++step) {
        scene.step();
        for (const BlowEvent& event : fracture.takeEvents()) {
            const btVector3 place(btScalar(event.position.x()), btScalar(event.position.y()),
                                  btScalar(event.position.z()));
            ASSERT_EQ(event.outcome, Outcome::held);
            ends.push_back((body->getWorldTransform().inverse() * place).x());
        }
    }
    EXPECT_TRUE(std::any_of(ends.begin(), ends.end(), [](double x) { return x > 0.2; }));
    EXPECT_TRUE(std::any_of(ends.begin(), ends.end(), [](double x) { return x < -0.2; }));
}

}  // namespace
