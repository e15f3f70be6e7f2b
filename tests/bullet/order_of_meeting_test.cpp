// Several bodies that strike one in the same step, and bodies behind each other: what meets first, what is
// held up before, and what is stopped once though several do it.

#include "bullet/plate_of_the_app.h"
#include "bullet/strikes/applied_blow.h"
#include "core/loads/contact_loads.h"
#include "fracture/blow_stress.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

constexpr int phases = 8;  // of the step in which a body is met

struct Stage {
    explicit Stage(double its_rate) : rate(its_rate) {}
    std::vector<BlowEvent> run(int steps = 8) {
        scene.step(steps, 1 / rate);
        return fracture.takeEvents();
    }
    double rate;
    TestWorld scene;
    FractureWorld fracture{scene.world.get()};
};

/// A breakable plate of 0.6 x 0.6 x 0.06 m, its lower face at z = 0, and what comes down on it.
struct Plate : Stage {
    explicit Plate(double its_rate) : Stage(its_rate) {
        EXPECT_TRUE(fracture.add(plate(crumbly()), at(0, 0, 0.03f)));
    }
    /// The ball is `gap_m` from its place when it touches.
    void throwBall(double mass_kg, double radius_m, double lowest_z, double speed_m_s, double gap_m) {
        scene.addBall(mass_kg, radius_m, btVector3(0, 0, btScalar(lowest_z + radius_m + gap_m)),
                      btVector3(0, 0, -btScalar(speed_m_s)));
    }
};

TEST(OrderOfMeeting, WhatLiesBeforeAWallIsStruckWhereverInAStepThatIs) {
    for (const double rate : {60.0, 240.0})
        for (const double speed : {1.0, 3.0, 7.0})
            for (int phase = 0; phase < phases; ++phase) {
                Plate before_wall(rate);
                before_wall.scene.addFloor()->setRestitution(0.5);
                before_wall.throwBall(2, 0.2, 0.06, speed, speed / rate * (phase + 0.5) / phases);
                before_wall.scene.bodies.back()->setRestitution(0.5);
                const auto events = before_wall.run();
                EXPECT_FALSE(events.empty()) << rate << " Hz, " << speed << " m/s, phase " << phase;
            }
}

TEST(OrderOfMeeting, WhatIsBehindAWallIsNotStruck) {
    for (const double rate : {60.0, 240.0})
        for (int phase = 0; phase < phases; ++phase) {
            Plate behind_wall(rate);
            behind_wall.scene.addBox(0, btVector3(1, 1, 0.005f), btVector3(0, 0, 0.075f));
            behind_wall.throwBall(2, 0.2, 0.08, 6, 6 / rate * (phase + 0.5) / phases);
            EXPECT_TRUE(behind_wall.run().empty()) << rate << " Hz, phase " << phase;
        }
}

TEST(OrderOfMeeting, NorIsItByWhatLandsFlatOnTheWall) {
    for (int phase = 0; phase < phases; ++phase) {
        Plate behind_wall(60);
        behind_wall.scene.addBox(0, btVector3(1, 1, 0.005f), btVector3(0, 0, 0.075f));
        btRigidBody* cube =
            behind_wall.scene.addBox(8, btVector3(0.1f, 0.1f, 0.1f),
                                     btVector3(0, 0, btScalar(0.18 + 6.0 / 60 * (phase + 0.5) / phases)));
        cube->setLinearVelocity(btVector3(0, 0, -6));
        EXPECT_TRUE(behind_wall.run().empty()) << "phase " << phase;
    }
}

// A slab that lands on a block at one end turns about it, and its other end goes on.
TEST(OrderOfMeeting, WhatTurnsAboutItsStopStrikesWithItsOtherEnd) {
    for (const double rate : {60.0, 240.0})
        for (const double speed : {0.5, 1.0, 2.5})
            for (int phase = 0; phase < phases; ++phase) {
                Plate under_an_end(rate);
                under_an_end.scene.addBox(0, btVector3(0.1f, 0.3f, 0.0315f), btVector3(1.3f, 0, 0.0315f));
                btRigidBody* slab = under_an_end.scene.addBox(
                    30, btVector3(1, 0.2f, 0.02f),
                    btVector3(0.65f, 0, btScalar(0.063 + 0.02 + speed / rate * (phase + 0.5) / phases)));
                slab->setLinearVelocity(btVector3(0, 0, -btScalar(speed)));
                EXPECT_FALSE(under_an_end.run().empty())
                    << rate << " Hz, " << speed << " m/s, phase " << phase;
            }
}

// Bullet then pushes the ball out on the other side.
TEST(OrderOfMeeting, WhatABallIsHalfThroughItHasStruck) {
    for (const double speed : {4.0, 8.0})
        for (int phase = 0; phase < phases; ++phase) {
            Plate struck(60);
            struck.throwBall(2, 0.05, 0.06, speed, speed / 60 * (phase + 0.5) / phases);
            EXPECT_FALSE(struck.run().empty()) << speed << " m/s, phase " << phase;
        }
}

/// A crumbly cube of 0.2 m, or a lower block, on a floor of two bodies whose seam is at x = 0.
struct OnASeam : Stage {
    OnASeam(double its_rate, double gap_m, const btVector3& velocity, double height_m = 0.2)
        : Stage(its_rate) {
        for (const btScalar side : {-1.0f, 1.0f})
            scene.addBox(0, btVector3(2, 2, 0.5f), btVector3(2 * side, 0, -0.5f));
        const Vec3 half(0.1, 0.1, height_m / 2);
        Settings settings = coarse(height_m / 4);
        settings.fracture.smallest_fragment_m3 = 1e-4;
        const auto asset = BreakableAsset::fromMesh(shapes::box(-half, half), crumbly(), settings);
        cube = fracture.add(asset.value(), at(0.01f, 0, btScalar(half.z() + gap_m))).value();
        cube->setLinearVelocity(velocity);
        cube->setFriction(0);
    }
    btRigidBody* cube = nullptr;
};

// Bullet then pushes it aside, half of it to either body.
TEST(OrderOfMeeting, WhatIsDeepInTheSeamItFallsOnHasLandedThere) {
    for (const double speed : {4.0, 8.0})
        for (int phase = 0; phase < phases; ++phase) {
            OnASeam falling(60, speed / 60 * (phase + 0.5) / phases, btVector3(0, 0, -btScalar(speed)));
            const auto events = falling.run(4);
            ASSERT_FALSE(events.empty()) << speed << " m/s, phase " << phase;
            EXPECT_GT(events[0].normal.z(), 0.9) << speed << " m/s, phase " << phase;
        }
}

TEST(OrderOfMeeting, WhatSlidesOverASeamIsNotStruckByIt) {
    for (const double rate : {60.0, 240.0, 960.0}) {
        OnASeam sliding(rate, 0, btVector3(0, 0, 0));
        sliding.scene.world->setGravity(btVector3(0, 0, -10));
        sliding.cube->setGravity(btVector3(0, 0, -10));
        sliding.cube->translate(btVector3(-1, 0, 0));
        sliding.run(int(rate / 4));
        sliding.cube->setLinearVelocity(btVector3(5, 0, 0));
        EXPECT_TRUE(sliding.run(int(0.4 * rate)).empty()) << rate << " Hz";
        EXPECT_GT(sliding.cube->getCenterOfMassPosition().x(), 0.5);
    }
}

// It lands at 1 m/s and goes on at 3: its first step leaves it 20 mm deep in the first body, and its second
// takes it further than that into the next.
TEST(OrderOfMeeting, NorDoesWhatIsSunkMeetTheEdgeOfTheNext) {
    for (int phase = 0; phase < phases; ++phase) {
        OnASeam sunk(60, 0, btVector3(3, 0, 0), 0.06);
        sunk.cube->translate(btVector3(btScalar(-0.11 - 0.028 * (phase + 0.5) / phases), 0, -0.02f));
        EXPECT_TRUE(sunk.run(6).empty()) << "phase " << phase;
        EXPECT_GT(sunk.cube->getCenterOfMassPosition().x(), 0.05) << "phase " << phase;
    }
}

TEST(OrderOfMeeting, TheEventNamesWhatBroughtMost) {
    Plate struck(240);
    const double gap = 0.005;
    struck.throwBall(20, 0.05, 0.06, 4, gap);
    const btRigidBody* heavy = struck.scene.bodies.back().get();
    btRigidBody* pea = struck.scene.addBall(0.001, 0.005, btVector3(-0.1f, 0, 0.06f + 0.005f + btScalar(gap)),
                                            btVector3(0, 0, -5));
    pea->setGravity(btVector3(0, 0, 0));
    const auto events = struck.run();
    ASSERT_FALSE(events.empty());
    EXPECT_EQ(events[0].striker, heavy);
}

/// The strike of a step in which the plate comes down flat on a floor of so many bodies a side.
Strike landing(int bodies_a_side) {
    constexpr double dt = 1.0 / 240;
    TestWorld scene;
    const double size = 2.0 / bodies_a_side;
    for (int i = 0; i < bodies_a_side; ++i)
        for (int j = 0; j < bodies_a_side; ++j)
            scene.addBox(0, btVector3(btScalar(size / 2), btScalar(size / 2), 0.5f),
                         btVector3(btScalar((i + 0.5) * size - 1), btScalar((j + 0.5) * size - 1), -0.501f));
    PlateOfTheApp plate(scene, btVector3(0, 0, 0.03f));
    plate.box->setLinearVelocity(btVector3(0, 0, -1));
    scene.step(1, dt);
    return plate.strikeOfStep(dt);
}

TEST(OrderOfMeeting, AFloorOfFourBodiesStopsWhatFallsOnTheirSeamOnce) {
    const Strike on_one = landing(1), on_four = landing(2);
    EXPECT_GT(on_four.points.size(), on_one.points.size());
    EXPECT_NEAR(impactOf(on_four, 0).energy(), impactOf(on_one, 0).energy(),
                1e-3 * impactOf(on_one, 0).energy());
    EXPECT_NEAR(impactOf(on_one, 0).energy(), 0.5 * plate(crumbly()).mass(),
                0.01 * impactOf(on_one, 0).energy());
}

/// Energy of the strike that a push of 3 N s makes, in `parts` on a circle, J.
double energyOfPush(int parts, double speed_m_s, bool is_held) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    BodyOptions options(at(0, 0, 0));
    if (is_held) options.supports = {BoxRegion{{-0.3, -0.3, -0.3}, {-0.28, 0.3, 0.3}}};
    btRigidBody* body = fracture.add(plate(crumbly()), options).value();
    const auto asset = *fracture.asset(body);
    Breakable breakable(asset, fractureSettingsFor(asset, asset.settings().fracture));
    breakable.body = body;
    std::vector<Push> pushes;
    for (int i = 0; i < parts; ++i) {
        const btScalar turn = btScalar(2 * M_PI * i / parts), radius = parts > 1 ? 0.05f : 0;
        pushes.push_back({btVector3(radius * btCos(turn), radius * btSin(turn), 0.03f),
                          btVector3(0, 0, -3 / btScalar(parts)), 0.02, speed_m_s});
    }
    const StruckBreakable struck = asContacts(breakable, pushes);
    const BreakableSolid& solid = *asset.solid();
    const Strike strike =
        strikeOf(struckBody(solid, struck.blow), struck.blow, asset.settings().fracture.contact);
    EXPECT_LE(broughtEnergy(solid, struck.blow, strike),
              blowEnergy(struck.blow, solid.mass(), is_held) * (1 + 1e-9));
    return broughtEnergy(solid, struck.blow, strike);
}

TEST(OrderOfMeeting, APushInPartsBringsWhatItBringsAsOne) {
    for (const bool is_held : {false, true})
        for (const double speed : {0.0, 30.0}) {
            const double as_one = energyOfPush(1, speed, is_held);
            EXPECT_GT(as_one, 0);
            for (const int parts : {2, 3, 8})
                EXPECT_NEAR(energyOfPush(parts, speed, is_held), as_one, 0.02 * as_one)
                    << parts << " parts at " << speed << " m/s" << (is_held ? ", held" : "");
        }
}

}  // namespace
