// Blows that wait, and limits of what a step brings.

#include <algorithm>
#include <deque>
#include <mutex>
#include <numeric>
#include <set>
#include <thread>

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

/// A plate that breaks at a touch, again and again, and what it falls on.
struct FallingPlate {
    explicit FallingPlate(const Budget& budget = {}, const Settings& settings = brittle()) {
        scene.world->setGravity(btVector3(0, 0, -9.81f));
        scene.addFloor();
        fracture = std::make_unique<FractureWorld>(scene.world.get());
        EXPECT_TRUE(fracture->setBudget(budget).ok());
        const auto asset = BreakableAsset::fromMesh(
            shapes::box(Vec3(-0.3, -0.3, -0.03), Vec3(0.3, 0.3, 0.03)), crumbly(), settings);
        mass_kg = asset.value().mass();
        BodyOptions options;
        // Tilted: what lands flat comes to rest at once.
        options.start =
            btTransform(btQuaternion(btVector3(1, 0.4f, 0).normalized(), 0.2f), btVector3(0, 0, 0.15f));
        options.velocity = btVector3(0, 0, -5);
        EXPECT_TRUE(fracture->add(asset.value(), options).ok());
    }
    ~FallingPlate() { fracture.reset(); }

    static Settings brittle() {
        Settings settings = coarse(0.06);
        settings.fracture.smallest_fragment_m3 = 3e-4;
        settings.fracture.rest_after_break_s = settings.fracture.same_blow_s = 0;
        settings.fracture.fragment_count = 4;
        settings.fracture.crack_pattern = CrackPattern::seeds;  // equal pieces: many of them break again
        return settings;
    }
    std::vector<BlowEvent> run(int steps, double dt = 1.0 / 60) {
        std::vector<BlowEvent> events;
        for (int i = 0; i < steps; ++i) {
            scene.step(1, dt);
            for (BlowEvent& event : fracture->takeEvents()) events.push_back(std::move(event));
        }
        return events;
    }
    int fragmentCount() const { return static_cast<int>(fracture->bodies().size()); }
    double massInWorld() const {
        double mass = 0;
        for (const btRigidBody* body : fracture->bodies()) mass += 1 / double(body->getInvMass());
        return mass;
    }
    std::vector<btScalar> numbers() const {
        std::vector<btScalar> all;
        for (const btRigidBody* body : fracture->bodies()) {
            btScalar matrix[16];
            body->getWorldTransform().getOpenGLMatrix(matrix);
            all.insert(all.end(), matrix, matrix + 16);
            for (int axis = 0; axis < 3; ++axis) all.push_back(body->getLinearVelocity()[axis]);
        }
        return all;
    }

    TestWorld scene;
    std::unique_ptr<FractureWorld> fracture;
    double mass_kg = 0;
};

int count(const std::vector<BlowEvent>& events, Outcome outcome) {
    return static_cast<int>(std::count_if(events.begin(), events.end(),
                                          [&](const BlowEvent& event) { return event.outcome == outcome; }));
}

/// Runs jobs in the reverse order, and not before the next was handed in.
struct LateExecutor {
    std::deque<std::function<void()>> jobs;
    Executor executor() {
        return [this](std::function<void()> job) {
            jobs.push_front(std::move(job));
            if (jobs.size() < 3) return;
            std::thread([&] { jobs.front()(); }).join();
            jobs.pop_front();
        };
    }
};

TEST(Budget, BlowsOnFragmentsAreDecidedLater) {
    FallingPlate fall;
    const auto events = fall.run(40);
    ASSERT_FALSE(events.empty());
    EXPECT_EQ(events.front().outcome, Outcome::broke);
    EXPECT_EQ(events.front().waited_s, 0) << "the whole body breaks at once";
    int later = 0;
    for (std::size_t i = 1; i < events.size(); ++i) {
        EXPECT_GE(events[i].waited_s, fall.fracture->budget().shortest_wait_s - 1e-9);
        later += events[i].outcome == Outcome::broke;
    }
    EXPECT_GT(later, 1);
    EXPECT_GE(fall.fracture->counts().waited, later);
    EXPECT_NEAR(fall.massInWorld(), fall.mass_kg, 1e-4 * fall.mass_kg);
}

/// Plates over a floor, in a row; the budget has no room for one in a step.
struct RowOfPlates {
    explicit RowOfPlates(int count, btScalar speed) {
        scene.addFloor();
        fracture = std::make_unique<FractureWorld>(scene.world.get());
        Budget budget;
        budget.milliseconds_per_step = 1;  // a plate takes 19
        EXPECT_TRUE(fracture->setBudget(budget).ok());
        const auto asset = BreakableAsset::fromMesh(
            shapes::box(Vec3(-0.3, -0.3, -0.03), Vec3(0.3, 0.3, 0.03)), likeSand(), coarse(0.06));
        for (int i = 0; i < count; ++i) {
            BodyOptions options;
            options.start = at(btScalar(i), 0, 0.0299f);  // boxes touch where they overlap
            options.velocity = btVector3(0, 0, -speed);
            plates.push_back(fracture->add(asset.value(), options).value());
        }
    }
    ~RowOfPlates() { fracture.reset(); }

    static Material likeSand() {
        Material material = crumbly();
        material.tensile_strength_pa = 1e3;
        material.fracture_energy_j_m2 = 1e-4;
        return material;
    }

    /// How many of the plates break in so many steps.
    int breakIn(int steps) {
        int broken = 0;
        for (int i = 0; i < steps; ++i) {
            scene.step();
            for (const BlowEvent& event : fracture->takeEvents())
                broken += event.outcome == Outcome::broke && event.generation == 0;
        }
        return broken;
    }

    TestWorld scene;
    std::unique_ptr<FractureWorld> fracture;
    std::vector<btRigidBody*> plates;
};

TEST(Budget, FewThatFallBreakAtOnceAndManyALittleLater) {
    const int few = Budget().solves_per_step;
    EXPECT_EQ(RowOfPlates(few, 3).breakIn(1), few);
    RowOfPlates many(few + 1, 3);
    EXPECT_EQ(many.breakIn(1), 0);
    EXPECT_EQ(many.breakIn(200), few + 1);
}

// The first blow makes what the others need; a queue that had that for each of them would drop all but one.
TEST(Budget, ManyOfOneAssetThatIsNotPreparedBreak) {
    TestWorld scene;
    scene.addFloor();
    FractureWorld fracture(scene.world.get());
    const auto asset =
        BreakableAsset::fromMesh(shapes::box(Vec3(-0.2, -0.2, 0), Vec3(0.2, 0.2, 0.02)), Material::plaster());
    constexpr int count = 8;
    for (int i = 0; i < count; ++i) {
        BodyOptions options;
        options.start =
            btTransform(btQuaternion(btVector3(1, 0, 0), 1), btVector3(btScalar(0.6 * i), 0, 0.25f));
        options.velocity = btVector3(0, 0, -6);
        ASSERT_TRUE(fracture.add(asset.value(), options).ok());
    }
    int broken = 0;
    for (int step = 0; step < 60; ++step) {
        scene.step(1, 1. / 60);
        for (const BlowEvent& event : fracture.takeEvents())
            broken += event.outcome == Outcome::broke && event.generation == 0;
    }
    EXPECT_EQ(broken, count);
}

TEST(Budget, WhatABallBreaksGoesBeforeWhatFalls) {
    RowOfPlates row(2, 3);
    row.scene.addBall(5, 0.1, btVector3(0, 0, 0.162f), btVector3(0, 0, -8));
    EXPECT_EQ(row.breakIn(1), 1);
    EXPECT_FALSE(inWorld(row.scene, row.plates[0]));
    EXPECT_TRUE(inWorld(row.scene, row.plates[1]));
    EXPECT_EQ(row.breakIn(200), 1);
}

TEST(Budget, NoBlowWaitsWithoutOne) {
    FallingPlate fall(Budget::none());
    const auto events = fall.run(20);
    EXPECT_GT(count(events, Outcome::broke), 1);
    for (const BlowEvent& event : events) EXPECT_EQ(event.waited_s, 0);
    EXPECT_EQ(fall.fracture->counts().waited, 0);
}

TEST(Budget, ThreadsDoNotDecide) {
    const auto run = [](Executor executor) {
        FallingPlate fall;
        fall.fracture->setExecutor(std::move(executor));
        const auto events = fall.run(40);
        EXPECT_GT(count(events, Outcome::broke), 2);
        return fall.numbers();
    };
    const auto alone = run(nullptr);
    for (const int threads : {1, 2, 4}) EXPECT_EQ(run(workerThreads(threads)), alone) << threads;
    LateExecutor late;
    EXPECT_EQ(run(late.executor()), alone) << "late and out of order";
    EXPECT_EQ(run([](std::function<void()>) {}), alone) << "loses all jobs";
    EXPECT_EQ(run([](std::function<void()>) { throw std::runtime_error("full"); }), alone);
    EXPECT_EQ(run([](std::function<void()> job) { job(); }), alone) << "at once";
}

TEST(Budget, WhatWouldWaitTooLongIsDropped) {
    Budget budget;
    budget.milliseconds_per_step = 1e-3;
    budget.longest_wait_s = 0.1;
    FallingPlate fall(budget);
    const auto events = fall.run(20);
    const int dropped = count(events, Outcome::dropped);
    EXPECT_GT(dropped, 0);
    EXPECT_EQ(fall.fracture->counts().dropped, dropped);
    for (const BlowEvent& event : events)
        if (event.outcome == Outcome::dropped) {
            EXPECT_NE(event.message.find("Budget::longest_wait_s"), std::string::npos) << event.message;
            EXPECT_TRUE(event.fragments.empty());
        }
    EXPECT_NEAR(fall.massInWorld(), fall.mass_kg, 1e-4 * fall.mass_kg);
}

// So many blows are gated on several threads, and a check by a full solve asks for the strength.
TEST(Budget, ManyBlowsAtOnceAskTheAppForStrengthOnItsOwnThread) {
    TestWorld scene;
    scene.addFloor();
    FractureWorld fracture(scene.world.get());
    Settings settings = FallingPlate::brittle();
    settings.fracture.check_with_full_solve = true;
    std::mutex mutex;
    std::set<std::thread::id> threads;
    settings.strength.field = [&](const Vec3&) {
        const std::lock_guard<std::mutex> lock(mutex);
        threads.insert(std::this_thread::get_id());
        return 1.0;
    };
    const auto asset = BreakableAsset::fromMesh(shapes::box(Vec3(-0.3, -0.3, -0.03), Vec3(0.3, 0.3, 0.03)),
                                                crumbly(), settings);
    ASSERT_TRUE(asset.ok()) << asset.error();
    for (int i = 0; i < 24; ++i) {
        BodyOptions options;
        options.start = at(i, 0, 0.031f);
        options.velocity = btVector3(0, 0, -0.2f);
        ASSERT_TRUE(fracture.add(asset.value(), options).ok());
    }
    threads.clear();
    scene.step(12, 1.0 / 60);
    EXPECT_GT(fracture.counts().seen, 20);
    EXPECT_EQ(threads, std::set<std::thread::id>{std::this_thread::get_id()});
}

TEST(Budget, BreaksMakeFewerPiecesWhereThereIsLittleRoom) {
    Budget budget;
    budget.fragments_per_step = 3;
    FallingPlate few(budget);
    std::size_t most = 0;
    for (int i = 0; i < 40; ++i) {
        std::size_t born = 0;
        for (const BlowEvent& event : few.run(1)) born += event.fragments.size();
        most = std::max(most, born);
    }
    EXPECT_GE(most, 2u);
    EXPECT_LE(most, 3u);

    budget = Budget();
    budget.fragments_alive = 6;
    FallingPlate full(budget);
    const auto events = full.run(60);
    EXPECT_EQ(full.fragmentCount(), 6) << "a fragment that breaks into two takes one more place";
    EXPECT_GT(count(events, Outcome::dropped), 0);
    for (const BlowEvent& event : events)
        if (event.outcome == Outcome::dropped) {
            EXPECT_NE(event.message.find("Budget::fragments_alive"), std::string::npos) << event.message;
            EXPECT_EQ(event.level, Level::none);
            EXPECT_GT(event.impulse_n_s, 0) << "waited " << event.waited_s;
        }
    EXPECT_NEAR(full.massInWorld(), full.mass_kg, 1e-4 * full.mass_kg);
}

TEST(Budget, BodiesThatBreakAtOnceKeepToTheFragmentsAlive) {
    TestWorld scene;
    scene.addFloor();
    FractureWorld fracture(scene.world.get());
    Budget budget;
    budget.fragments_alive = 5;
    ASSERT_TRUE(fracture.setBudget(budget).ok());
    const auto asset = BreakableAsset::fromMesh(shapes::box(Vec3(-0.3, -0.3, -0.03), Vec3(0.3, 0.3, 0.03)),
                                                crumbly(), FallingPlate::brittle());
    for (int i = 0; i < 4; ++i) {
        BodyOptions options;
        options.start = at(i, 0, 0.035f);
        options.velocity = btVector3(0, 0, -5);
        ASSERT_TRUE(fracture.add(asset.value(), options).ok());
    }
    scene.step(8, 1.0 / 60);
    int fragments = 0;
    for (const btRigidBody* body : fracture.bodies()) fragments += fracture.generation(body) > 0;
    EXPECT_GE(fragments, 4);
    EXPECT_LE(fragments, 5);
    EXPECT_GT(count(fracture.takeEvents(), Outcome::dropped), 0);
}

TEST(Budget, WithoutRoomForTwoFragmentsNothingIsSolved) {
    Budget budget;
    budget.fragments_alive = 2;
    Settings settings = FallingPlate::brittle();
    int calls = 0;
    settings.fracture.guide.kind = GuideField::Kind::custom;
    settings.fracture.guide.custom = [&](const Vec3&, const Vec3&) {
        ++calls;
        return Vec3(1, 0, 0);
    };
    FallingPlate fall(budget, settings);
    ASSERT_EQ(count(fall.run(10), Outcome::broke), 1);
    ASSERT_GT(calls, 0);
    calls = 0;
    BodyOptions options(at(3, 0, 0.1f));
    options.velocity = btVector3(0, 0, -5);
    const auto another = BreakableAsset::fromMesh(shapes::box(Vec3(-0.3, -0.3, -0.03), Vec3(0.3, 0.3, 0.03)),
                                                  crumbly(), settings);
    ASSERT_TRUE(fall.fracture->add(another.value(), options).ok());
    const auto events = fall.run(10);
    EXPECT_TRUE(std::any_of(events.begin(), events.end(), [](const BlowEvent& event) {
        return event.outcome == Outcome::dropped && event.generation == 0;
    }));
    EXPECT_EQ(calls, 0);
}

TEST(Budget, WhatAStrikerFliesThroughNeverWaits) {
    for (const bool is_light : {true, false}) {
        TestWorld scene;
        FractureWorld fracture(scene.world.get());
        Settings settings = FallingPlate::brittle();
        settings.fracture.fragment_count = 2;
        const auto asset = BreakableAsset::fromMesh(
            shapes::box(Vec3(-0.3, -0.3, -0.03), Vec3(0.3, 0.3, 0.03)), crumbly(), settings);
        const auto body = fracture.add(asset.value(), at(0, 0, 0));
        ASSERT_TRUE(
            fracture.applyBlow(body.value(), {btVector3(0, 0, 0.03f), btVector3(0, 0, -30), 0.02f}).ok());
        ASSERT_GT(fracture.bodies().size(), 1u);
        btRigidBody* fragment = fracture.bodies().front();
        for (btRigidBody* other : fracture.bodies()) {
            other->setLinearVelocity(btVector3(0, 0, 0));
            other->setAngularVelocity(btVector3(0, 0, 0));
        }
        fracture.takeEvents();
        const btRigidBody* ball = scene.addBall(
            is_light ? 0.5 : 500, 0.05, fragment->getWorldTransform().getOrigin() + btVector3(0, 0, 0.12f),
            btVector3(0, 0, -10));
        const BlowEvent event = stepUntilBreak(scene, fracture);
        ASSERT_EQ(event.outcome, Outcome::broke);
        EXPECT_EQ(event.waited_s == 0, is_light) << "a heavy one goes on whether it breaks or not";
        EXPECT_EQ(event.striker, ball);
    }
}

TEST(Budget, WhatLightFragmentsStrikeMayWait) {
    enum class Struck { heavy, light, light_and_held };
    for (const Struck struck : {Struck::heavy, Struck::light, Struck::light_and_held}) {
        const bool waits = struck == Struck::heavy;
        TestWorld scene;
        FractureWorld fracture(scene.world.get());
        Budget budget;
        budget.milliseconds_per_step = 1;  // there is no room in a step
        budget.foresight_s = 0;
        ASSERT_TRUE(fracture.setBudget(budget).ok());
        Settings settings = FallingPlate::brittle();
        settings.fracture.fragment_count = 2;
        const auto plate = [&](double half_thickness) {
            return BreakableAsset::fromMesh(
                       shapes::box(Vec3(-0.3, -0.3, -half_thickness), Vec3(0.3, 0.3, half_thickness)),
                       RowOfPlates::likeSand(), settings)
                .value();
        };
        const auto broken = fracture.add(plate(0.03), at(0, 0, 0));
        ASSERT_TRUE(
            fracture.applyBlow(broken.value(), {btVector3(0, 0, 0.03f), btVector3(0, 0, -30), 0.02f}).ok());
        ASSERT_GT(fracture.bodies().size(), 1u);
        const std::vector<btRigidBody*> pieces = fracture.bodies();
        fracture.takeEvents();
        for (btRigidBody* piece : pieces) {
            piece->setLinearVelocity(btVector3(0, 0, 0));
            piece->setAngularVelocity(btVector3(0, 0, 0));
            if (piece != pieces.front()) piece->translate(btVector3(0, 0, 10));
        }
        pieces.front()->setLinearVelocity(btVector3(0, 0, -5));
        btTransform below = pieces.front()->getWorldTransform();
        below.setBasis(btMatrix3x3::getIdentity());
        below.getOrigin().setZ(-0.2f);
        BreakableAsset whole = plate(struck == Struck::heavy ? 0.06 : 0.015);
        const double piece_kg = 1 / pieces.front()->getInvMass();
        ASSERT_EQ(2 * piece_kg < whole.mass(), waits) << piece_kg << " " << whole.mass();
        if (struck == Struck::light_and_held)
            whole = whole.anchored({BoxRegion{{-0.3, -0.3, -1}, {-0.25, 0.3, 1}}}).value();
        ASSERT_TRUE(fracture.add(whole, below).ok());
        const auto of_whole = [](const BlowEvent& event) { return event.generation == 0; };
        std::vector<BlowEvent> events;
        for (int i = 0; i < 240 && std::none_of(events.begin(), events.end(), of_whole); ++i) {
            scene.step();
            for (BlowEvent& event : fracture.takeEvents()) events.push_back(std::move(event));
        }
        const auto event = std::find_if(events.begin(), events.end(), of_whole);
        ASSERT_NE(event, events.end());
        EXPECT_EQ(event->outcome, Outcome::broke);
        EXPECT_EQ(event->waited_s > 0, waits) << "a heavy one would bounce off what breaks";
    }
}

TEST(Budget, NoEventNamesAStrikerThatIsGone) {
    FallingPlate fall;
    btRigidBody* floor = fall.scene.bodies.front().get();
    std::vector<BlowEvent> events;
    while (events.empty()) events = fall.run(1);
    EXPECT_EQ(events.front().striker, floor);
    for (const BlowEvent& event : fall.run(2)) EXPECT_EQ(event.waited_s, 0);
    fall.scene.world->removeRigidBody(floor);
    int without = 0;
    for (const BlowEvent& event : fall.run(10)) {
        EXPECT_NE(event.striker, floor);
        without += event.waited_s > 0 && !event.striker;
    }
    EXPECT_GT(without, 0);
}

/// Six plates that are struck in one step: by the floor, or by a ball of `ball_kg` each. How many broke in
/// each step, from the first in which one broke.
std::vector<int> breaksOfACrowd(btScalar ball_kg, bool on_floor = false, double milliseconds = 1000) {
    const bool by_balls = ball_kg > 0;
    TestWorld scene;
    scene.addFloor();
    FractureWorld fracture(scene.world.get());
    Budget budget;
    budget.solves_per_step = 2;
    budget.milliseconds_per_step = milliseconds;
    budget.foresight_s = 0;  // what is solved ahead need not wait
    EXPECT_TRUE(fracture.setBudget(budget).ok());
    Settings settings = FallingPlate::brittle();
    settings.fracture.largest_generation = 1;
    const auto asset = BreakableAsset::fromMesh(shapes::box(Vec3(-0.3, -0.3, -0.03), Vec3(0.3, 0.3, 0.03)),
                                                crumbly(), settings);
    for (int i = 0; i < 6; ++i) {
        BodyOptions options;
        options.start = at(i, 0, on_floor ? 0.0299f : by_balls ? 1 : 0.035f);
        if (!by_balls) options.velocity = btVector3(0, 0, -5);
        EXPECT_TRUE(fracture.add(asset.value(), options).ok());
        if (by_balls)
            scene.addBall(ball_kg, 0.1, options.start.getOrigin() + btVector3(0, 0, 0.135f),
                          btVector3(0, 0, -5));
    }
    std::vector<int> broke;
    for (int step = 0; step < 8; ++step) {
        scene.step(1, 1.0 / 60);
        const int breaks = count(fracture.takeEvents(), Outcome::broke);
        if (breaks > 0 || !broke.empty()) broke.push_back(breaks);
    }
    return broke;
}

TEST(Budget, OfACrowdTheLeastUrgentWait) {
    constexpr btScalar too_heavy_to_be_slowed_kg = 50000;
    for (const btScalar ball_kg : {btScalar(0), too_heavy_to_be_slowed_kg}) {
        const std::vector<int> broke = breaksOfACrowd(ball_kg);
        ASSERT_FALSE(broke.empty());
        EXPECT_EQ(broke.front(), 2) << ball_kg;
        EXPECT_EQ(std::accumulate(broke.begin(), broke.end(), 0), 6) << ball_kg;
    }
}

TEST(Budget, NoCrowdIsFlownThroughLater) {
    const std::vector<int> broke = breaksOfACrowd(5);
    ASSERT_FALSE(broke.empty());
    EXPECT_EQ(broke.front(), 6);
}

TEST(Budget, AHeavyBodyRunsIntoACrowdWithoutAStall) {
    constexpr btScalar twenty_times_as_heavy_kg = 600;
    const std::vector<int> free = breaksOfACrowd(twenty_times_as_heavy_kg);
    ASSERT_FALSE(free.empty());
    EXPECT_EQ(free.front(), 2);
    EXPECT_EQ(std::accumulate(free.begin(), free.end(), 0), 6);
    const std::vector<int> backed = breaksOfACrowd(twenty_times_as_heavy_kg, true);
    ASSERT_FALSE(backed.empty());
    EXPECT_EQ(backed.front(), 6) << "whole they would stop it";
}

// Whatever they take: what is thrown whole and breaks in the air is seen.
TEST(Budget, OfACrowdThatIsRunIntoAsManyBreakAtOnceAsAStepHasSolves) {
    constexpr btScalar twenty_times_as_heavy_kg = 600, much_heavier_kg = 50000;
    constexpr double no_room_ms = 1e-3;
    for (const btScalar kg : {twenty_times_as_heavy_kg, much_heavier_kg}) {
        const std::vector<int> broke = breaksOfACrowd(kg, false, no_room_ms);
        ASSERT_FALSE(broke.empty());
        EXPECT_EQ(broke.front(), 2) << kg << " kg";
    }
}

/// Six plates of 21 kg and a platform, a kinematic one unless it has a mass, that moves towards them, or they
/// towards it: how long each waited until it broke, s.
std::vector<double> waitsOverAPlatform(bool moves, btScalar platform_kg = 0) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    Budget budget;
    budget.solves_per_step = 2;
    budget.milliseconds_per_step = 8;
    budget.foresight_s = 0;
    EXPECT_TRUE(fracture.setBudget(budget).ok());
    const auto asset = BreakableAsset::fromMesh(shapes::box(Vec3(-0.3, -0.3, -0.03), Vec3(0.3, 0.3, 0.03)),
                                                crumbly(), FallingPlate::brittle());
    for (int i = 0; i < 6; ++i) {
        BodyOptions options;
        options.start = at(i, 0, 1);
        if (!moves) options.velocity = btVector3(0, 0, -4.8f);
        EXPECT_TRUE(fracture.add(asset.value(), options).ok());
    }
    btBoxShape box(btVector3(4, 1, 0.1f));
    btVector3 inertia(0, 0, 0);
    if (platform_kg > 0) box.calculateLocalInertia(platform_kg, inertia);
    btRigidBody platform(btRigidBody::btRigidBodyConstructionInfo(platform_kg, nullptr, &box, inertia));
    if (platform_kg == 0)
        platform.setCollisionFlags(platform.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    platform.setActivationState(DISABLE_DEACTIVATION);
    platform.setWorldTransform(at(2.5f, 0, 0.5f));
    scene.world->addRigidBody(&platform);
    std::vector<double> waited_s;
    for (int step = 0; step < 60; ++step) {
        if (moves) platform.setWorldTransform(at(2.5f, 0, 0.5f + 0.08f * step));
        scene.step(1, 1.0 / 60);
        for (const BlowEvent& event : fracture.takeEvents())
            if (event.outcome == Outcome::broke && event.generation == 0) waited_s.push_back(event.waited_s);
    }
    scene.world->removeRigidBody(&platform);
    EXPECT_EQ(waited_s.size(), 6u);
    return waited_s;
}

TEST(Budget, AKinematicBodyRunsIntoACrowd) {
    const std::vector<double> run_into = waitsOverAPlatform(true), fallen = waitsOverAPlatform(false);
    EXPECT_EQ(std::count(run_into.begin(), run_into.end(), 0.0), 2);
    EXPECT_EQ(std::count(fallen.begin(), fallen.end(), 0.0), 0) << "as on the ground";
}

TEST(Budget, ACrowdFallsOnAFreeBodyWithoutAStall) {
    for (const btScalar heavier_kg : {100, 1000}) {
        const std::vector<double> waited_s = waitsOverAPlatform(false, heavier_kg);
        EXPECT_EQ(std::count(waited_s.begin(), waited_s.end(), 0.0), 0) << heavier_kg << " kg";
    }
    const std::vector<double> on_light = waitsOverAPlatform(false, 15);
    EXPECT_GT(std::count(on_light.begin(), on_light.end(), 0.0), 2) << "whole they would take it along";
}

TEST(Budget, FunctionsOfTheAppAreCalledOnTheSteppingThread) {
    Settings settings = FallingPlate::brittle();
    std::set<std::thread::id> threads;
    settings.fracture.guide.kind = GuideField::Kind::custom;
    settings.fracture.guide.custom = [&](const Vec3&, const Vec3&) {
        threads.insert(std::this_thread::get_id());
        return Vec3(1, 0, 0);
    };
    FallingPlate fall({}, settings);
    EXPECT_GT(count(fall.run(40), Outcome::broke), 1);
    EXPECT_EQ(threads, std::set<std::thread::id>{std::this_thread::get_id()});
}

TEST(Budget, MomentumIsKeptWhenBodiesBreakLater) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    const auto asset = BreakableAsset::fromMesh(shapes::box(Vec3(-0.3, -0.3, -0.03), Vec3(0.3, 0.3, 0.03)),
                                                crumbly(), FallingPlate::brittle());
    for (const btScalar side : {btScalar(-1), btScalar(1)}) {
        BodyOptions options;
        options.start = at(0.1f * side, 0, 0.1f * side);
        options.velocity = btVector3(0, 0, -3 * side);
        ASSERT_TRUE(fracture.add(asset.value(), options).ok());
    }
    const auto momentum = [&] {
        btVector3 sum(0, 0, 0);
        for (const btRigidBody* body : fracture.bodies())
            sum += body->getLinearVelocity() / body->getInvMass();
        return sum;
    };
    scene.step(120);
    EXPECT_GT(fracture.counts().waited, 0);
    EXPECT_GT(fracture.bodies().size(), 8u);
    EXPECT_LT(momentum().length(), 1e-3 * 6 * asset.value().mass());
}

TEST(Budget, OddOnesAreRefused) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    const auto refused = [&](auto set, const char* field) {
        Budget budget;
        set(budget);
        const Status status = fracture.setBudget(budget);
        EXPECT_FALSE(status.ok()) << field;
        EXPECT_NE(status.error().find(field), std::string::npos) << status.error();
    };
    refused([](Budget& b) { b.shortest_wait_s = -1; }, "shortest_wait_s");
    refused([](Budget& b) { b.shortest_wait_s = NAN; }, "shortest_wait_s");
    refused([](Budget& b) { b.longest_wait_s = 0.01; }, "longest_wait_s");
    refused([](Budget& b) { b.milliseconds_per_step = -1; }, "milliseconds_per_step");
    refused([](Budget& b) { b.solves_per_step = 0; }, "solves_per_step");
    refused([](Budget& b) { b.priority = Priority(9); }, "priority");
    refused([](Budget& b) { b.viewpoint.x() = INFINITY; }, "viewpoint");
    refused([](Budget& b) { b.fragments_per_step = 1; }, "fragments_per_step");
    refused([](Budget& b) { b.fragments_alive = 0; }, "fragments_alive");
    EXPECT_EQ(fracture.budget().solves_per_step, Budget().solves_per_step);
    EXPECT_TRUE(fracture.setBudget(Budget::none()).ok());
}

TEST(Generations, FragmentsBreakAsOftenAsTheyMay) {
    Settings settings = FallingPlate::brittle();
    settings.fracture.largest_generation = 1;
    FallingPlate once(Budget::none(), settings);
    EXPECT_EQ(count(once.run(40), Outcome::broke), 1);
    settings.fracture.largest_generation = 2;
    FallingPlate twice(Budget::none(), settings);
    EXPECT_GT(count(twice.run(40), Outcome::broke), 1);
}

// Pieces that are born between the substeps of a frame have the weight that Bullet would give them.
TEST(Generations, FallAlikeHoweverFramesGroupTheSubsteps) {
    const auto fallen = [](int substeps) {
        FallingPlate fall;
        constexpr double dt = 1.0 / 256;  // no rounding in sums
        for (int i = 0; i < 256 / substeps; ++i)
            fall.scene.world->stepSimulation(btScalar(substeps * dt), substeps, btScalar(dt));
        EXPECT_GT(fall.fragmentCount(), 8);  // some broke again
        return fall.numbers();
    };
    EXPECT_EQ(fallen(1), fallen(4));
}

}  // namespace
