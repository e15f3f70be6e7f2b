// What goes on through a body that is held, into what its supports still hold of it.

#include <algorithm>
#include <vector>

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

constexpr double window_m = 1.2, frame_m = 0.02;

/// A pane in the x-z plane about the origin, held along its four edges.
struct Window {
    TestWorld scene;
    FractureWorld fracture{scene.world.get()};
    btRigidBody* body = nullptr;
    double mass_kg = 0;

    explicit Window(int largest_generation = 0) : Window(settingsOf(largest_generation)) {}

    explicit Window(const Settings& settings) {
        const auto asset = BreakableAsset::fromMesh(shapes::slab(Vec3(window_m, 0.01, window_m)),
                                                    Material::glass(), settings);
        EXPECT_TRUE(asset.ok()) << asset.error();
        mass_kg = asset.value().mass();
        const double edge = window_m / 2, inner = edge - frame_m;
        BodyOptions options;
        options.supports = {
            BoxRegion{{-edge, -1, -edge}, {edge, 1, -inner}}, BoxRegion{{-edge, -1, inner}, {edge, 1, edge}},
            BoxRegion{{-edge, -1, -edge}, {-inner, 1, edge}}, BoxRegion{{inner, -1, -edge}, {edge, 1, edge}}};
        body = fracture.add(asset.value(), options).value();
    }

    static Settings settingsOf(int largest_generation) {
        Settings settings = Settings::forQuality(Quality::preview);
        settings.fracture.largest_generation = largest_generation;
        return settings;
    }
    btRigidBody* throwCrate(double mass_kg, double size_m, double speed_m_s) {
        const btScalar half = btScalar(size_m / 2);
        btRigidBody* crate =
            scene.addBox(mass_kg, btVector3(half, half, half), btVector3(0.03f, -half - btScalar(0.3), 0));
        crate->setLinearVelocity(btVector3(0, btScalar(speed_m_s), 0));
        crate->setActivationState(DISABLE_DEACTIVATION);
        return crate;
    }
    std::vector<BlowEvent> fly(double hz) {
        scene.step(int(0.8 * hz), 1 / hz);
        return fracture.takeEvents();
    }
};

/// Of what breaks, the events that say so.
std::vector<BlowEvent> breaksIn(std::vector<BlowEvent> events) {
    events.erase(std::remove_if(events.begin(), events.end(),
                                [](const BlowEvent& event) { return event.outcome != Outcome::broke; }),
                 events.end());
    return events;
}

// A striker that takes all of the pane with it keeps m / (m + M) of its speed; what the frame keeps, and what
// flies off to the sides, lets it keep more.
TEST(TornOut, ACrateGoesOnThroughAWindow) {
    for (const double hz : {60., 240.})
        for (const double size : {0.3, 0.7, 1.0, 1.4}) {
            Window window;
            const btRigidBody* crate = window.throwCrate(30, size, 8);
            const auto events = window.fly(hz);
            ASSERT_FALSE(breaksIn(events).empty()) << size;
            EXPECT_GT(crate->getLinearVelocity().y(), 0.7 * 8 * 30 / (30 + window.mass_kg))
                << size << " m at " << hz << " Hz";
            EXPECT_GT(crate->getCenterOfMassPosition().y() - size / 2, 0.01) << size << " m at " << hz;
        }
}

TEST(TornOut, WhatIsNotInTheWayStaysInTheFrame) {
    Window window;
    window.throwCrate(30, 0.3, 8);
    window.fly(60);
    int held = 0;
    for (const btRigidBody* piece : window.fracture.bodies()) {
        if (!piece->isStaticObject()) continue;
        ++held;
        EXPECT_FALSE(window.fracture.asset(piece)->supports().empty());
    }
    EXPECT_GT(held, 3);
}

TEST(TornOut, TheEventHasThePieceThatItWasFree) {
    Window window;
    window.throwCrate(300, 0.9, 8);
    int torn = 0;
    for (const BlowEvent& event : breaksIn(window.fly(60))) {
        if (event.level != Level::gate) continue;
        ++torn;
        EXPECT_GT(event.generation, 0);
        EXPECT_FALSE(event.message.empty());
        EXPECT_GT(event.impulse_n_s, 0.01 * 300 * 5) << "what takes a trifle of the crate's momentum stays";
        ASSERT_LE(event.fragments.size(), 1u);
        if (event.fragments.empty()) continue;  // which has broken since
        const btRigidBody* piece = event.fragments[0];
        const auto asset = window.fracture.asset(piece);
        if (!asset) continue;
        EXPECT_TRUE(asset->supports().empty());
        EXPECT_FALSE(piece->isStaticObject());
        EXPECT_NEAR(1 / piece->getInvMass(), event.asset.mass(), 1e-5 * event.asset.mass());
        EXPECT_EQ(asset->surface().vertices.size(), event.asset.surface().vertices.size());
    }
    EXPECT_GT(torn, 2);
}

// What is torn out uncovers the rests beside it, which took nothing before.
TEST(TornOut, WhatComesLongAfterTheBreakGoesThroughToo) {
    for (const double hz : {60., 240.}) {
        Window window;
        btRigidBody* first = window.throwCrate(30, 0.3, 8);
        window.fly(hz);
        window.scene.world->removeRigidBody(first);
        const btRigidBody* crate = window.throwCrate(40, 1, 10);
        int torn = 0;
        for (const BlowEvent& event : breaksIn(window.fly(hz))) torn += event.level == Level::gate;
        EXPECT_GT(torn, 0);
        EXPECT_GT(crate->getLinearVelocity().y(), 0.7 * 10 * 40 / (40 + window.mass_kg)) << hz;
    }
}

TEST(TornOut, ABallThatAThickRestStopsBreaksNoMoreOfItInTheStep) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    const auto wall =
        BreakableAsset::fromMesh(shapes::box({-1, -0.05, 0}, {1, 0.05, 1.5}), Material::plaster());
    BodyOptions options;
    options.supports = {BoxRegion{{-1, -1, 0}, {1, 1, 0.3}}};
    ASSERT_TRUE(fracture.add(wall.value(), options).ok());
    scene.addBall(10, 0.15, btVector3(0.03f, -0.5f, 0.2f), btVector3(0, 20, 0));
    std::size_t most = 0;
    for (int i = 0; i < 20; ++i) {
        scene.step(1, 1. / 120);
        most = std::max(most, breaksIn(fracture.takeEvents()).size());
    }
    EXPECT_GE(most, 1u);
    EXPECT_LE(most, 3u);
}

// A crate larger than the window breaks one rest after the other, each about as heavy as it.
TEST(TornOut, BeyondTheSolvesOfAStepRestsComeOutWholeAndBreakLater) {
    struct Run {
        int most_at_once = 0, waited = 0;
        double speed_m_s = 0;
    };
    const auto fly = [](const Budget& budget, int largest_generation) {
        Window window(largest_generation);
        EXPECT_TRUE(window.fracture.setBudget(budget).ok());
        const btRigidBody* crate = window.throwCrate(30, 1.4, 8);
        Run run;
        double dropped_kg = 0;
        for (int step = 0; step < 40; ++step) {
            window.scene.step(1, 1. / 60);
            int at_once = 0;
            for (const BlowEvent& event : window.fracture.takeEvents()) {
                dropped_kg += event.dropped_mass_kg;
                at_once += event.waited_s == 0 && event.level != Level::gate && !event.foreseen;
                run.waited += event.waited_s > 0 && event.outcome == Outcome::broke;
            }
            run.most_at_once = std::max(run.most_at_once, at_once);
        }
        double left_kg = dropped_kg;
        for (const btRigidBody* piece : window.fracture.bodies())
            left_kg += window.fracture.asset(piece)->mass();
        EXPECT_NEAR(left_kg, window.mass_kg, 1e-4 * window.mass_kg);
        run.speed_m_s = crate->getLinearVelocity().y();
        return run;
    };
    Budget two;
    two.solves_per_step = 2;
    const Run with = fly(two, 0);
    EXPECT_LE(with.most_at_once, 2);
    EXPECT_GT(with.waited, 0);
    const double with_all_of_it = 0.7 * 8 * 30 / (30 + Window().mass_kg);
    EXPECT_GT(with.speed_m_s, with_all_of_it);
    EXPECT_GT(fly(Budget::none(), 0).most_at_once, 2);
    const Run of_generations = fly(two, 3);
    EXPECT_GT(of_generations.waited, 0) << "what is torn out first may break as before";
    EXPECT_GT(of_generations.speed_m_s, with_all_of_it);
}

TEST(TornOut, FragmentsThatNeverBreakComeOutAllTheSame) {
    Window window(1);
    const btRigidBody* crate = window.throwCrate(300, 1, 8);
    for (const BlowEvent& event : breaksIn(window.fly(60)))
        EXPECT_TRUE(event.generation == 0 || event.level == Level::gate) << event.generation;
    EXPECT_GT(crate->getLinearVelocity().y(), 0.7 * 8 * 300 / (300 + window.mass_kg));
}

// What is held after the first break is several times as heavy as the ball, but little of it is in the way.
TEST(TornOut, AFastBallGoesThroughAWindow) {
    for (const int largest_generation : {0, 1})
        for (const double hz : {60., 240.})
            for (const double speed : {20., 30.}) {
                Settings settings = Window::settingsOf(largest_generation);
                settings.fracture.largest_fragment_count = 12;
                settings.fracture.guide.kind = GuideField::Kind::radial;
                Window window(settings);
                btRigidBody* const ball = window.scene.addBall(0.5, 0.06, btVector3(0.11f, -0.5f, 0.07f),
                                                               btVector3(0, btScalar(speed), 0));
                ball->setCcdMotionThreshold(0.06f);
                ball->setCcdSweptSphereRadius(0.05f);
                ASSERT_FALSE(breaksIn(window.fly(hz)).empty());
                EXPECT_GT(ball->getLinearVelocity().y(), 0.05 * speed)
                    << hz << " Hz, " << speed << " m/s, " << largest_generation;
            }
}

TEST(TornOut, WhatOnlyTouchesARestLeavesItInTheFrame) {
    Window window;
    window.throwCrate(30, 0.3, 8);
    window.fly(60);
    std::vector<const btRigidBody*> rests;
    for (const btRigidBody* piece : window.fracture.bodies())
        if (piece->isStaticObject()) rests.push_back(piece);
    ASSERT_FALSE(rests.empty());
    // A wide plate that creeps into what is left.
    btRigidBody* plate = window.scene.addBox(30, btVector3(0.55f, 0.05f, 0.55f), btVector3(0, -0.06f, 0));
    plate->setLinearVelocity(btVector3(0, 1e-3f, 0));
    window.scene.step(60, 1. / 60);
    const std::vector<btRigidBody*> after = window.fracture.bodies();
    for (const btRigidBody* rest : rests) EXPECT_NE(std::find(after.begin(), after.end(), rest), after.end());
}

}  // namespace
