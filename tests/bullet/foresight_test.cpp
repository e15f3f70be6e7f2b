// Blows that are solved before they fall.

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

const BreakableAsset& preparedPlate() {
    static const BreakableAsset asset = [] {
        const BreakableAsset of_plate = plate(crumbly());
        EXPECT_TRUE(of_plate.prepare().ok());
        return of_plate;
    }();
    return asset;
}

BodyOptions upright() {
    BodyOptions options;
    options.start = btTransform(btQuaternion(btVector3(1, 0, 0), SIMD_HALF_PI), btVector3(0, 0, 0.3f));
    return options;
}

/// A plate that stands on the floor, and a ball that flies at it. Jobs are done as soon as they are there.
struct BallAtPlate {
    explicit BallAtPlate(double foresight_s = Budget().foresight_s, WorldKind kind = WorldKind::plain)
        : scene(kind) {
        scene.world->setGravity(btVector3(0, 0, -9.81f));
        floor = scene.addFloor();
        fracture = std::make_unique<FractureWorld>(scene.world.get());
        Budget budget;
        budget.foresight_s = foresight_s;
        EXPECT_TRUE(fracture->setBudget(budget).ok());
        fracture->setExecutor([this](std::function<void()> job) {
            ++jobs;
            job();
        });
        target = fracture->add(preparedPlate(), upright()).value();
        ball = scene.addBall(1, 0.05, {0.05f, -1, 0.35f}, {0, 6, 0.5f});
    }
    ~BallAtPlate() { fracture.reset(); }

    /// Another body instead of the plate.
    void replaceTarget(const BreakableAsset& asset, const BodyOptions& options) {
        fracture->remove(target);
        target = fracture->add(asset, options).value();
    }
    /// One that falls and turns, where the ball is not.
    void letFall(const BreakableAsset& asset, const btVector3& velocity = {0, 0, 0},
                 const btVector3& angular_velocity = {0, 0, 0}) {
        ball->translate(btVector3(3, 0, 0));
        BodyOptions options;
        options.start =
            btTransform(btQuaternion(btVector3(1, 0.4f, 0).normalized(), 0.5f), btVector3(0, 0, 1));
        options.velocity = velocity;
        options.angular_velocity = angular_velocity;
        replaceTarget(asset, options);
    }
    /// Until the plate breaks, at most so many steps. How many it took.
    int breakIt(int most = 100, double dt = 1.0 / 240) {
        for (int i = 0; i < most; ++i) {
            scene.step(1, dt);
            for (BlowEvent& event : fracture->takeEvents())
                if (event.outcome == Outcome::broke) {
                    broken.push_back(std::move(event));
                    return i + 1;
                }
        }
        return most + 1;
    }
    std::vector<btScalar> numbers() const {
        std::vector<btScalar> all;
        const auto& objects = scene.world->getCollisionObjectArray();
        for (int i = 0; i < objects.size(); ++i) {
            btScalar matrix[16];
            objects[i]->getWorldTransform().getOpenGLMatrix(matrix);
            all.insert(all.end(), matrix, matrix + 16);
            for (int axis = 0; axis < 3; ++axis)
                all.push_back(objects[i]->getInterpolationLinearVelocity()[axis]);
        }
        return all;
    }

    TestWorld scene;
    btRigidBody *floor = nullptr, *target = nullptr, *ball = nullptr;
    std::unique_ptr<FractureWorld> fracture;
    std::vector<BlowEvent> broken;
    int jobs = 0;
};

TEST(Foresight, ABlowIsSolvedBeforeItFalls) {
    BallAtPlate scene;
    const double ahead_s = scene.fracture->budget().foresight_s;
    int before_break = 0;
    const int most = 100;
    int step = 0;
    for (; step < most && scene.broken.empty(); ++step) {
        if (scene.jobs == 0) before_break = step;
        scene.breakIt(1);
    }
    ASSERT_FALSE(scene.broken.empty());
    EXPECT_EQ(scene.fracture->counts().foreseen, 1);
    EXPECT_EQ(scene.fracture->counts().foreseen_in_vain, 0);
    EXPECT_GE(step - before_break, 0.9 * std::min(ahead_s, step / 240.0) * 240)
        << "steps between the job and the break";
    const BlowEvent& broken = scene.broken.front();
    EXPECT_EQ(broken.waited_s, 0);
    EXPECT_EQ(broken.striker, scene.ball);
    EXPECT_TRUE(broken.foreseen);
    EXPECT_GT(broken.ms_elsewhere.solve, 0);
    EXPECT_EQ(broken.ms_elsewhere.solve, broken.ms.solve) << "all of it was solved before";
    EXPECT_EQ(broken.ms_elsewhere.swap, 0) << "bodies are swapped in the step";
}

/// A body that falls freely breaks as if nothing had been foreseen, to the last bit.
TEST(Foresight, ChangesNothingOfWhatFlies) {
    for (const double rate : {60.0, 240.0}) {
        std::vector<std::vector<btScalar>> numbers;
        for (const double foresight_s : {0.0, 0.1}) {
            BallAtPlate scene(foresight_s);
            scene.letFall(preparedPlate(), btVector3(0.5f, 0, -2), btVector3(1, 2, 0.5f));
            ASSERT_LE(scene.breakIt(200, 1 / rate), 200);
            EXPECT_EQ(scene.fracture->counts().foreseen, foresight_s > 0 ? 1 : 0) << rate << " Hz";
            scene.scene.step(10, 1 / rate);
            numbers.push_back(scene.numbers());
        }
        EXPECT_EQ(numbers[0], numbers[1]) << rate << " Hz";
    }
}

TEST(Foresight, IsTheSameWithAnyThreads) {
    std::vector<std::vector<btScalar>> numbers;
    for (int threads = -1; threads <= 2; ++threads) {
        BallAtPlate scene;
        if (threads == 0) scene.fracture->setExecutor({});
        if (threads > 0) scene.fracture->setExecutor(workerThreads(threads));
        ASSERT_LE(scene.breakIt(), 100);
        EXPECT_EQ(scene.fracture->counts().foreseen, 1);
        scene.scene.step(20);
        numbers.push_back(scene.numbers());
    }
    for (const auto& other : numbers) EXPECT_EQ(numbers.front(), other);
}

/// What it stands on stands on something, too: all of it is looked at, or it would fall.
TEST(Foresight, ABlowOnTheTopOfAColumnIsForeseen) {
    BallAtPlate scene;
    constexpr int boxes = 6;
    for (int i = 0; i < boxes; ++i)
        scene.scene.addBox(20, btVector3(0.4f, 0.4f, 0.05f), btVector3(0, 0, 0.05f + 0.1f * btScalar(i)));
    const btVector3 up(0, 0, 0.1f * boxes);
    BodyOptions options = upright();
    options.start.getOrigin() += up;
    scene.replaceTarget(preparedPlate(), options);
    const btTransform ball = scene.ball->getWorldTransform();
    const btVector3 velocity = scene.ball->getLinearVelocity();
    scene.ball->translate(btVector3(0, -50, 0));
    scene.scene.step(120);  // until the column stands
    scene.ball->setWorldTransform(ball);
    scene.ball->translate(up);
    scene.ball->setLinearVelocity(velocity);
    EXPECT_LE(scene.breakIt(), 100);
    EXPECT_EQ(scene.fracture->counts().foreseen, 1);
    EXPECT_EQ(scene.fracture->counts().foreseen_in_vain, 0);
}

TEST(Foresight, WorksInAllWorlds) {
    for (const WorldKind kind :
         {WorldKind::owns_its_solver, WorldKind::threaded, WorldKind::soft, WorldKind::multi_body}) {
        BallAtPlate scene(0.1, kind);
        EXPECT_LE(scene.breakIt(), 100) << int(kind);
        EXPECT_EQ(scene.fracture->counts().foreseen, 1) << int(kind);
    }
}

/// A blow that falls otherwise than foreseen is that which falls.
TEST(Foresight, WhatTheAppTurnsAsideIsSolvedWhenItFalls) {
    std::vector<double> stresses;
    for (const double foresight_s : {0.0, 0.1}) {
        BallAtPlate scene(foresight_s);
        scene.breakIt(20);
        EXPECT_EQ(scene.jobs > 0, foresight_s > 0) << "the blow is foreseen by then";
        scene.ball->setLinearVelocity({0, 6.6f, 0.5f});
        scene.breakIt(1);
        scene.fracture->setExecutor({});  // what is to come is solved as it falls
        ASSERT_LE(scene.breakIt(), 100);
        stresses.push_back(scene.broken.front().largest_stress_pa);
        EXPECT_EQ(scene.fracture->counts().foreseen_in_vain > 0, foresight_s > 0);
    }
    EXPECT_NEAR(stresses[1], stresses[0], 0.02 * stresses[0]);
}

/// Only the striker is followed: what the struck body does shows when the blow falls.
TEST(Foresight, ABodyThatMovesAtTheLastMomentIsStruckAtItsOwnSpeed) {
    BallAtPlate same;
    const int steps = same.breakIt();
    ASSERT_LE(steps, 100);
    BallAtPlate scene;
    ASSERT_GT(scene.breakIt(steps - 1), steps - 1);
    scene.target->activate();
    scene.target->setLinearVelocity({0, -0.5f, 0});
    EXPECT_EQ(scene.breakIt(1), 1);
    EXPECT_EQ(scene.fracture->counts().foreseen, 0);
}

/// A force of the app's that goes on, as an engine's does.
TEST(Foresight, WhatIsDrivenGoesOnAsItDid) {
    BallAtPlate scene;
    scene.ball->setLinearVelocity({0, 6, 0});
    for (int i = 0; i < 100 && scene.broken.empty(); ++i) {
        scene.ball->applyCentralForce(btVector3(0, 0, 9.81f));
        scene.breakIt(1);
    }
    ASSERT_FALSE(scene.broken.empty());
    EXPECT_EQ(scene.fracture->counts().foreseen, 1);
}

/// What the app changes of the striker after its blow was foreseen counts, though it goes the same way.
TEST(Foresight, AStrikerOfAnotherMassOrFrictionIsAnother) {
    const std::vector<std::function<void(btRigidBody&)>> changes{
        [](btRigidBody& ball) {
            btVector3 inertia;
            ball.getCollisionShape()->calculateLocalInertia(0.1f, inertia);
            ball.setMassProps(0.1f, inertia);
            ball.updateInertiaTensor();
            ball.setGravity(ball.getGravity());
        },
        [](btRigidBody& ball) { ball.setFriction(2); }};
    for (const auto& change : changes) {
        std::vector<double> stresses;
        for (const double foresight_s : {0.0, 0.1}) {
            BallAtPlate scene(foresight_s);
            scene.breakIt(20);
            EXPECT_EQ(scene.jobs > 0, foresight_s > 0);
            change(*scene.ball);
            ASSERT_LE(scene.breakIt(), 100);
            EXPECT_EQ(scene.fracture->counts().foreseen, 0);
            stresses.push_back(scene.broken.front().largest_stress_pa);
        }
        EXPECT_EQ(stresses[0], stresses[1]);
    }
}

TEST(Foresight, AsksTheAppsFilters) {
    BallAtPlate scene;
    scene.ball->setIgnoreCollisionCheck(scene.target, true);
    EXPECT_EQ(scene.breakIt(), 101);
    EXPECT_EQ(scene.jobs, 0);
}

/// As many as the time to be looked at has would take minutes.
TEST(Foresight, TinyStepsAreRehearsedForAWhileOnly) {
    BallAtPlate scene;
    EXPECT_EQ(scene.breakIt(200, 1e-6), 201);
    EXPECT_EQ(scene.breakIt(10, 1e-8), 11);  // no step at all, for Bullet
    EXPECT_EQ(scene.jobs, 0);
}

/// A push of the app's comes first.
TEST(Foresight, APushBetweenIsABlowOfItsOwn) {
    for (const double foresight_s : {0.0, 0.1}) {
        BallAtPlate scene(foresight_s);
        scene.breakIt(20);
        EXPECT_EQ(scene.jobs > 0, foresight_s > 0);
        Push push;
        push.point = scene.target->getWorldTransform().getOrigin() + btVector3(0, -0.03f, 0);
        push.impulse_n_s = btVector3(0, 5, 0);
        ASSERT_TRUE(scene.fracture->applyBlow(scene.target, push).ok());
        const auto events = scene.fracture->takeEvents();
        ASSERT_EQ(events.size(), 1u);
        EXPECT_EQ(events.front().outcome, Outcome::broke);
        EXPECT_EQ(events.front().striker, nullptr);
        EXPECT_EQ(scene.fracture->counts().foreseen, 0);
    }
}

TEST(Foresight, ABallThatGoesAwayBreaksNothing) {
    BallAtPlate scene;
    scene.breakIt(20);
    EXPECT_GT(scene.jobs, 0);
    scene.scene.world->removeRigidBody(scene.ball);
    scene.scene.bodies.pop_back();  // deletes it
    EXPECT_EQ(scene.breakIt(60), 61);
    EXPECT_EQ(scene.fracture->counts().foreseen_in_vain, 1);
    EXPECT_EQ(scene.fracture->counts().foreseen, 0);
}

TEST(Foresight, ABodyThatIsRemovedIsStruckByNothing) {
    BallAtPlate scene;
    scene.breakIt(20);
    EXPECT_GT(scene.jobs, 0);
    scene.fracture->remove(scene.target);
    EXPECT_EQ(scene.breakIt(60), 61);
    EXPECT_EQ(scene.fracture->counts().foreseen_in_vain, 1);
}

TEST(Foresight, NoneWithoutBudgetForIt) {
    BallAtPlate scene(0);
    EXPECT_LE(scene.breakIt(), 100);
    EXPECT_EQ(scene.jobs, 0);
    BallAtPlate none;
    ASSERT_TRUE(none.fracture->setBudget(Budget::none()).ok());
    EXPECT_LE(none.breakIt(), 100);
    EXPECT_EQ(none.fracture->counts().foreseen, 0);
}

/// A full solve says the same before as in the step.
TEST(Foresight, WhatIsNotPreparedIsSolvedBeforeToo) {
    std::vector<std::vector<btScalar>> numbers;
    for (const double foresight_s : {0.0, 0.1}) {
        BallAtPlate scene(foresight_s);
        scene.letFall(plate(crumbly()));
        ASSERT_LE(scene.breakIt(200), 200);
        EXPECT_EQ(scene.broken.front().level, Level::full);
        EXPECT_EQ(scene.fracture->counts().foreseen, foresight_s > 0 ? 1 : 0);
        scene.scene.step(10);
        numbers.push_back(scene.numbers());
    }
    EXPECT_EQ(numbers[0], numbers[1]);
}

/// What a worker has solved in full before is not what the prepared body answers.
TEST(Foresight, WhatIsPreparedMeanwhileIsAskedAgain) {
    std::vector<std::vector<btScalar>> numbers;
    for (const bool has_threads : {true, false}) {
        BallAtPlate scene;
        if (!has_threads) scene.fracture->setExecutor(nullptr);
        const BreakableAsset asset = plate(crumbly());
        scene.replaceTarget(asset, upright());
        scene.scene.step(25);
        ASSERT_EQ(scene.fracture->counts().seen, 0);
        EXPECT_EQ(scene.jobs, has_threads ? 1 : 0);
        ASSERT_TRUE(asset.prepare().ok());
        ASSERT_LE(scene.breakIt(), 100);
        EXPECT_EQ(scene.broken.front().level, Level::reduced);
        EXPECT_EQ(scene.fracture->counts().foreseen, 0);
        EXPECT_FALSE(scene.broken.front().foreseen);
        EXPECT_EQ(scene.broken.front().ms_elsewhere.total(), 0);
        numbers.push_back(scene.numbers());
    }
    EXPECT_EQ(numbers[0], numbers[1]);
}

/// Each full solve leaves its factor behind, and most blows of a crowd are dropped.
TEST(Foresight, OfACrowdThatIsNotPreparedAsManyAsAStepSolves) {
    TestWorld scene;
    scene.world->setGravity(btVector3(0, 0, -9.81f));
    scene.addFloor();
    FractureWorld fracture(scene.world.get());
    Budget budget;
    budget.solves_per_step = 2;
    ASSERT_TRUE(fracture.setBudget(budget).ok());
    int jobs = 0;
    fracture.setExecutor([&](std::function<void()> job) {
        ++jobs;
        job();
    });
    for (int i = 0; i < 6; ++i) ASSERT_TRUE(fracture.add(plate(crumbly()), at(btScalar(i), 0, 0.6f)).ok());
    while (fracture.counts().seen == 0 && fracture.counts().waited == 0 &&
           scene.dispatcher->getNumManifolds() == 0)
        scene.step();
    EXPECT_EQ(jobs, budget.solves_per_step);
}

/// In a long step its upper corners come near the ground, too: which of them the solver presses is chance.
TEST(Foresight, AFlatLandingIsForeseen) {
    for (const double rate : {60, 120, 240}) {
        TestWorld scene;
        scene.world->setGravity(btVector3(0, 0, -9.81f));
        scene.addFloor();
        FractureWorld fracture(scene.world.get());
        for (int i = 0; i < 3; ++i)
            ASSERT_TRUE(fracture.add(preparedPlate(), at(0.7f * btScalar(i), 0, 0.8f)).ok());
        scene.step(static_cast<int>(0.5 * rate), 1 / rate);
        EXPECT_EQ(fracture.counts().foreseen, 3) << rate << " Hz";
    }
}

/// Plates that fall side by side, after another one that is not prepared if there is such a one: the events
/// of their breaks.
std::vector<BlowEvent> breaksOfFallingPlates(const Budget& budget, int count = 12,
                                             const BreakableAsset* before = nullptr) {
    TestWorld scene;
    scene.world->setGravity(btVector3(0, 0, -9.81f));
    scene.addFloor();
    FractureWorld fracture(scene.world.get());
    EXPECT_TRUE(fracture.setBudget(budget).ok());
    if (before) {
        BodyOptions options;
        options.start = at(-2, 0, 0.5f);
        options.name = "before";
        EXPECT_TRUE(fracture.add(*before, options).ok());
    }
    for (int i = 0; i < count; ++i) {
        BodyOptions options;
        options.start = at(0.7f * btScalar(i % 4), 0.7f * btScalar(i / 4), before ? 4 : 0.8f);
        options.name = std::to_string(i);
        EXPECT_TRUE(fracture.add(preparedPlate(), options).ok());
    }
    std::vector<BlowEvent> breaks;
    for (int step = 0; step < 90; ++step) {
        scene.step(1, 1.0 / 60);
        for (BlowEvent& event : fracture.takeEvents())
            if (event.outcome == Outcome::broke && event.generation == 0 && event.name != "before")
                breaks.push_back(std::move(event));
    }
    EXPECT_EQ(breaks.size(), static_cast<std::size_t>(count));
    return breaks;
}

long brokenAtOnce(const std::vector<BlowEvent>& breaks) {
    return std::count_if(breaks.begin(), breaks.end(),
                         [](const BlowEvent& event) { return event.waited_s == 0; });
}

TEST(Foresight, OfACrowdAsManyBreakAtOnceAsThereWasTimeFor) {
    Budget budget;
    budget.solves_per_step = 1;
    budget.foresight_s = 0;
    EXPECT_LE(brokenAtOnce(breaksOfFallingPlates(budget)), 1);
    budget.foresight_s = 0.1;
    const std::vector<BlowEvent> breaks = breaksOfFallingPlates(budget);
    // Seen 0.1 to 0.2 s before, one in 30 to 40 ms.
    EXPECT_GE(brokenAtOnce(breaks), 2);
    EXPECT_LE(brokenAtOnce(breaks), 7);
    for (const BlowEvent& event : breaks) EXPECT_TRUE(event.foreseen || event.waited_s > 0);
    budget.milliseconds_per_step = 1000;
    budget.solves_per_step = budget.fragments_per_step = 1000;
    EXPECT_EQ(brokenAtOnce(breaksOfFallingPlates(budget)), 12);
}

TEST(Foresight, WhatWasSolvedForMorePiecesThanAStepHasRoomForWaits) {
    Budget budget;
    budget.milliseconds_per_step = 1000;
    budget.solves_per_step = 1000;
    const std::vector<BlowEvent> breaks = breaksOfFallingPlates(budget);
    const std::size_t pieces = breaks.front().fragments.size();
    ASSERT_GT(pieces, 6u);
    for (const BlowEvent& event : breaks) ASSERT_EQ(event.fragments.size(), pieces);
    budget.fragments_per_step = 3 * static_cast<int>(pieces);
    const std::vector<BlowEvent> in_turn = breaksOfFallingPlates(budget);
    EXPECT_EQ(brokenAtOnce(in_turn), 3);
    const auto piecesOf = [](const std::vector<BlowEvent>& events) {
        std::map<std::string, std::size_t> pieces;
        for (const BlowEvent& event : events) pieces[event.name] = event.fragments.size();
        return pieces;
    };
    EXPECT_EQ(piecesOf(breaks), piecesOf(in_turn));
}

TEST(Foresight, ALargeBlowThatIsOverTakesNoTimeFromLaterOnes) {
    const BreakableAsset large = plate(crumbly(), 0.02);
    const std::vector<BlowEvent> breaks = breaksOfFallingPlates(Budget(), 6, &large);
    EXPECT_GE(brokenAtOnce(breaks), 2);
}

TEST(Foresight, WhereRoomIsShortAllHaveAShareOfIt) {
    Budget budget;
    budget.milliseconds_per_step = 1000;
    budget.solves_per_step = 1000;
    budget.fragments_alive = 24;
    for (const BlowEvent& event : breaksOfFallingPlates(budget, 6)) EXPECT_EQ(event.fragments.size(), 4u);
    budget = Budget();
    budget.shortest_wait_s = 0;
    budget.fragments_per_step = 20;
    for (const BlowEvent& event : breaksOfFallingPlates(budget, 6)) EXPECT_LE(event.fragments.size(), 3u);
}

/// Bullet looks for no contacts of what sleeps, but has those of before when it wakes.
TEST(Foresight, OfACrowdThatWouldWaitNoMoreThanThereIsTimeFor) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    for (int i = 0; i < 8; ++i)
        ASSERT_TRUE(fracture.add(preparedPlate(), at(0.7f * btScalar(i) - 2.45f, 0, 0)).ok());
    btRigidBody* lid = scene.addBox(50000, btVector3(3, 0.3f, 0.1f), btVector3(0, 0, 0.26f));
    lid->setLinearVelocity(btVector3(0, 0, -2));
    scene.step(6);
    scene.world->removeRigidBody(lid);
    scene.step(1);
    EXPECT_GT(fracture.counts().foreseen_in_vain, 0);
    EXPECT_LE(fracture.counts().foreseen_in_vain, 4) << "in 50 ms";
}

TEST(Foresight, WhatSleepsIsStruckAsItStands) {
    for (const btScalar speed : {15, 12, 10, 8, 6}) {
        TestWorld scene;
        scene.world->setGravity(btVector3(0, 0, -9.81f));
        scene.addFloor();
        FractureWorld fracture(scene.world.get());
        const btScalar half = btScalar(0.2);
        btRigidBody* const crate = scene.addBox(64, btVector3(half, half, half), btVector3(0, 0, half));
        ASSERT_TRUE(fracture.makeBreakable(crate, Material::plaster(), coarse(0.08)).ok());
        scene.step(180, 1.0 / 60);
        ASSERT_FALSE(crate->isActive());
        scene.addBall(100, 0.2, btVector3(-3, 0, 0.3f), btVector3(speed, 0, 9.81f * 1.5f / speed));
        for (int i = 0; i < 60 && fracture.counts().solved() == 0; ++i) scene.step(1, 1.0 / 60);
        EXPECT_EQ(fracture.counts().foreseen, 1) << speed << " m/s";
        EXPECT_EQ(fracture.counts().foreseen_in_vain, 0) << speed << " m/s";
    }
}

/// The app calls its own functions on the thread that steps.
TEST(Foresight, NoneOfWhatAsksTheApp) {
    BallAtPlate scene;
    Settings settings = coarse(0.06);
    settings.strength.field = [](const Vec3&) { return 1.0; };
    const auto asset = BreakableAsset::fromMesh(plate(crumbly()).surface(), crumbly(), settings);
    ASSERT_TRUE(asset.ok()) << asset.error();
    scene.replaceTarget(asset.value(), upright());
    EXPECT_LE(scene.breakIt(), 100);
    EXPECT_EQ(scene.fracture->counts().foreseen, 0);
}

btScalar nothing(const btCollisionObject*, const btCollisionObject*) {
    return 0;
}

/// How the app combines two materials may depend on what it knows of the bodies.
TEST(Foresight, NoneWhereTheAppCombinesMaterials) {
    BallAtPlate scene;
    gCalculateCombinedRestitutionCallback = nothing;
    const int steps = scene.breakIt();
    gCalculateCombinedRestitutionCallback = btManifoldResult::calculateCombinedRestitution;
    EXPECT_LE(steps, 100);
    EXPECT_EQ(scene.fracture->counts().foreseen, 0);
}

int calls = 0, calls_of_strangers = 0;
constexpr int of_the_app = 7;  // user index of its bodies, which their fragments inherit

void noteCall(const void* a, const void* b) {
    ++calls;
    for (const void* body : {a, b})
        if (static_cast<const btCollisionObject*>(body)->getUserIndex() != of_the_app) ++calls_of_strangers;
}

bool processed(btManifoldPoint&, void* a, void* b) {
    noteCall(a, b);
    return false;
}

bool added(btManifoldPoint&, const btCollisionObjectWrapper* a, int, int, const btCollisionObjectWrapper* b,
           int, int) {
    noteCall(a->getCollisionObject(), b->getCollisionObject());
    return false;
}

/// The app hears of contacts of its own bodies only.
TEST(Foresight, NoCallbackSeesAStandIn) {
    for (const bool of_added : {true, false}) {
        BallAtPlate scene;
        for (btRigidBody* body : {scene.target, scene.ball, scene.floor}) {
            body->setUserIndex(of_the_app);
            body->setCollisionFlags(body->getCollisionFlags() |
                                    btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
        }
        calls = calls_of_strangers = 0;
        gContactAddedCallback = of_added ? added : nullptr;
        gContactProcessedCallback = of_added ? nullptr : processed;
        const int steps = scene.breakIt();
        gContactAddedCallback = nullptr;
        gContactProcessedCallback = nullptr;
        EXPECT_LE(steps, 100);
        EXPECT_EQ(scene.fracture->counts().foreseen, of_added ? 1 : 0);
        EXPECT_GT(calls, 0);
        EXPECT_EQ(calls_of_strangers, 0);
    }
}

}  // namespace
