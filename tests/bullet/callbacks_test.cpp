// Every public call from every callback of Bullet's: it works, is refused with a sentence, or waits for the
// end of the step.

#include <functional>
#include <memory>
#include <tuple>

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

constexpr auto broke = Outcome::broke;

enum class Callback {
    near,
    contact_added,
    contact_processed,
    contact_destroyed,
    contact_ended,
    pair_filter,
    tick_before,
    tick_after,
    action,
    drawer,
    motion_state,
};
constexpr const char* callback_names[] = {
    "near",          "contact_added", "contact_processed", "contact_destroyed",
    "contact_ended", "pair_filter",   "tick_before",       "tick_after",
    "action",        "drawer",        "motion_state"};

enum class Call { events, add, make_breakable, remove, remove_all, blow, questions, destroy };
constexpr const char* call_names[] = {"events",     "add",  "make_breakable", "remove",
                                      "remove_all", "blow", "questions",      "destroy"};

/// What Bullet's global callbacks call.
std::function<void()>& task() {
    static std::function<void()> function;
    return function;
}
void runTask() {
    if (task()) task()();
}

bool onContactAdded(btManifoldPoint&, const btCollisionObjectWrapper*, int, int,
                    const btCollisionObjectWrapper*, int, int) {
    runTask();
    return true;
}
bool onContactProcessed(btManifoldPoint&, void*, void*) {
    runTask();
    return true;
}
int persistent_data = 0;  // a contact is only reported as destroyed if the app attached something to it
bool attachData(btManifoldPoint& point, void*, void*) {
    point.m_userPersistentData = &persistent_data;
    return true;
}
bool onContactDestroyed(void*) {
    runTask();
    return true;
}
void onContactEnded(btPersistentManifold* const&) {
    runTask();
}
void onNear(btBroadphasePair& pair, btCollisionDispatcher& dispatcher, const btDispatcherInfo& info) {
    runTask();
    btCollisionDispatcher::defaultNearCallback(pair, dispatcher, info);
}
void onTick(btDynamicsWorld*, btScalar) {
    runTask();
}

struct Filter : btOverlapFilterCallback {
    bool needBroadphaseCollision(btBroadphaseProxy*, btBroadphaseProxy*) const override {
        runTask();
        return true;
    }
};

struct Action : btActionInterface {
    void updateAction(btCollisionWorld*, btScalar) override { runTask(); }
    void debugDraw(btIDebugDraw*) override {}
};

struct Drawer : btIDebugDraw {
    void drawLine(const btVector3&, const btVector3&, const btVector3&) override { runTask(); }
    void drawContactPoint(const btVector3&, const btVector3&, btScalar, int, const btVector3&) override {}
    void reportErrorWarning(const char*) override {}
    void draw3dText(const btVector3&, const char*) override {}
    void setDebugMode(int) override {}
    int getDebugMode() const override { return DBG_DrawWireframe; }
};

struct MotionState : btDefaultMotionState {
    using btDefaultMotionState::btDefaultMotionState;
    void setWorldTransform(const btTransform& transform) override {
        btDefaultMotionState::setWorldTransform(transform);
        runTask();
    }
};

/// A ball that breaks a plate, and a ball of the app's beside.
class Stage {
  public:
    explicit Stage(Callback where) {
        plate_body = fracture->add(asset, at(0, 0, 0)).value();
        ball = scene.addBall(2, 0.1, btVector3(0.05f, 0, 0.15f), btVector3(0, 0, -8));
        apps_body = scene.addBox(1, btVector3(0.1f, 0.1f, 0.1f), btVector3(3, 0, 0));
        // Something that comes and goes with a contact, all the while.
        scene.addBox(0, btVector3(0.5f, 0.5f, 0.1f), btVector3(0, 3, -0.3f));
        bouncer = scene.addBall(1, 0.1, btVector3(0, 3, 0), btVector3(0, 0, -8));
        bouncer->setRestitution(1);
        for (btRigidBody* body : {plate_body, ball, bouncer})
            body->setCollisionFlags(body->getCollisionFlags() |
                                    btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
        own_objects = scene.world->getNumCollisionObjects() - 1;
        listen(where);
    }
    ~Stage() {
        task() = nullptr;
        gContactAddedCallback = nullptr;
        gContactProcessedCallback = nullptr;
        gContactDestroyedCallback = nullptr;
        gContactEndedCallback = nullptr;
        scene.world->setInternalTickCallback(nullptr);
        scene.world->setInternalTickCallback(nullptr, nullptr, true);
        scene.world->removeAction(&action);
        scene.broadphase->getOverlappingPairCache()->setOverlapFilterCallback(nullptr);
    }

    void run(int steps = 30) {
        for (int i = 0; i < steps; ++i) {
            scene.step();
            if (scene.world->getDebugDrawer()) scene.world->debugDrawWorld();
        }
    }

    TestWorld scene;
    const BreakableAsset asset = plate(crumbly(), 0.1);
    Filter filter;
    Action action;
    Drawer drawer;
    MotionState motion_state;
    std::unique_ptr<FractureWorld> fracture = std::make_unique<FractureWorld>(scene.world.get());
    btRigidBody *plate_body = nullptr, *ball = nullptr, *apps_body = nullptr, *bouncer = nullptr;
    int own_objects = 0;  // of the app

  private:
    void listen(Callback where) {
        switch (where) {
            case Callback::near:
                scene.dispatcher->setNearCallback(onNear);
                break;
            case Callback::contact_added:
                gContactAddedCallback = onContactAdded;
                break;
            case Callback::contact_processed:
                gContactProcessedCallback = onContactProcessed;
                break;
            case Callback::contact_destroyed:
                gContactProcessedCallback = attachData;
                gContactDestroyedCallback = onContactDestroyed;
                break;
            case Callback::contact_ended:
                gContactEndedCallback = onContactEnded;
                break;
            case Callback::pair_filter:
                scene.broadphase->getOverlappingPairCache()->setOverlapFilterCallback(&filter);
                break;
            case Callback::tick_before:
                scene.world->setInternalTickCallback(onTick, nullptr, true);
                break;
            case Callback::tick_after:
                scene.world->setInternalTickCallback(onTick);
                break;
            case Callback::action:
                scene.world->addAction(&action);
                break;
            case Callback::drawer:
                scene.world->setDebugDrawer(&drawer);
                break;
            case Callback::motion_state:
                motion_state.m_graphicsWorldTrans = ball->getWorldTransform();
                ball->setMotionState(&motion_state);
                break;
        }
    }
};

class EveryCallback : public testing::TestWithParam<std::tuple<Callback, Call>> {
  protected:
    Stage stage{std::get<0>(GetParam())};
    int calls = 0;
    std::vector<BlowEvent> taken;

    int breaks() {
        if (stage.fracture)
            for (BlowEvent& event : stage.fracture->takeEvents()) taken.push_back(std::move(event));
        int count = 0;
        for (const BlowEvent& event : taken) count += event.outcome == broke;
        return count;
    }
    int objectsOfTheApp() const { return stage.own_objects; }
    int objects() const { return stage.scene.world->getNumCollisionObjects(); }
    void expectBreak() {
        EXPECT_EQ(breaks(), 1);
        const auto standing = stage.fracture->bodies();
        for (const BlowEvent& event : taken) {
            if (event.outcome != broke) continue;
            EXPECT_EQ(event.body, stage.plate_body);
            EXPECT_GT(event.fragments.size(), 1u);
            for (btRigidBody* piece : event.fragments)
                EXPECT_NE(std::find(standing.begin(), standing.end(), piece), standing.end());
        }
    }

    void takeEvents() {
        task() = [&] {
            ++calls;
            for (BlowEvent& event : stage.fracture->takeEvents()) taken.push_back(std::move(event));
        };
        stage.run();
        expectBreak();
    }
    void add() {
        int added = 0;
        task() = [&] {
            if (++calls > 20) return;
            const auto body = stage.fracture->add(stage.asset, at(10, 10, btScalar(calls)));
            if (body)
                ++added;
            else
                EXPECT_NE(body.error().find("inside a step"), std::string::npos);
        };
        stage.run();
        task() = nullptr;
        expectBreak();
        EXPECT_EQ(objects(), objectsOfTheApp() + added + static_cast<int>(taken.back().fragments.size()));
        EXPECT_TRUE(stage.fracture->add(stage.asset, at(10, 10, 100)).ok())
            << "after the step it works again";
    }
    void makeBreakable() {
        task() = [&] {
            ++calls;
            const Status made = stage.fracture->makeBreakable(stage.apps_body, crumbly(), coarse(0.1));
            if (made)
                EXPECT_NE(stage.fracture->asset(stage.apps_body), nullptr);
            else
                EXPECT_FALSE(made.error().empty());
        };
        stage.run();
        task() = nullptr;
        expectBreak();
    }
    void remove() {
        task() = [&] {
            if (calls++ == 0) stage.fracture->remove(stage.plate_body);
        };
        stage.run();
        EXPECT_TRUE(stage.fracture->bodies().empty()) << "the body, or what it broke into, is still there";
        EXPECT_EQ(objects(), objectsOfTheApp());
        for (const BlowEvent& event : stage.fracture->takeEvents()) EXPECT_TRUE(event.fragments.empty());
    }
    void removeAll() {
        task() = [&] {
            ++calls;
            for (btRigidBody* body : stage.fracture->bodies()) stage.fracture->remove(body);
        };
        stage.run();
        EXPECT_TRUE(stage.fracture->bodies().empty());
        EXPECT_EQ(objects(), objectsOfTheApp());
    }
    /// A blow on the body that is about to break, or on what is left of it.
    void strike() {
        task() = [&] {
            if (++calls > 3) return;
            for (btRigidBody* body : stage.fracture->bodies()) {
                Push push;
                push.point = body->getCenterOfMassPosition();
                push.impulse_n_s = btVector3(0, 0, 5);
                EXPECT_EQ(stage.fracture->applyBlow(body, push).error(), "");
            }
        };
        stage.run();
        task() = nullptr;
        EXPECT_GE(breaks(), 1);
        EXPECT_GT(stage.fracture->bodies().size(), 1u);
    }
    void ask() {
        task() = [&] {
            ++calls;
            stage.fracture->counts();
            for (const btRigidBody* body : stage.fracture->bodies()) {
                EXPECT_NE(stage.fracture->asset(body), nullptr);
                EXPECT_TRUE(std::isfinite(stage.fracture->assetTransform(body).getOrigin().x()));
            }
            EXPECT_EQ(stage.fracture->asset(stage.ball), nullptr);
        };
        stage.run();
        expectBreak();
    }
    void destroy() {
        task() = [&] {
            if (calls++ == 0) stage.fracture.reset();
        };
        btConstraintSolver* const own = stage.scene.solver.get();
        stage.run();
        EXPECT_EQ(stage.fracture, nullptr);
        EXPECT_EQ(objects(), objectsOfTheApp());
        EXPECT_EQ(stage.scene.world->getConstraintSolver(), own);
    }
};

TEST_P(EveryCallback, TakesEveryCall) {
    switch (std::get<1>(GetParam())) {
        case Call::events:
            takeEvents();
            break;
        case Call::add:
            add();
            break;
        case Call::make_breakable:
            makeBreakable();
            break;
        case Call::remove:
            remove();
            break;
        case Call::remove_all:
            removeAll();
            break;
        case Call::blow:
            strike();
            break;
        case Call::questions:
            ask();
            break;
        case Call::destroy:
            if (std::get<0>(GetParam()) == Callback::drawer)
                GTEST_SKIP() << "the header rules it out: Bullet goes on drawing the shape that is gone";
            destroy();
            break;
    }
    EXPECT_GT(calls, 0) << "the callback was never called";
}

INSTANTIATE_TEST_SUITE_P(
    Matrix, EveryCallback,
    testing::Combine(testing::Values(Callback::near, Callback::contact_added, Callback::contact_processed,
                                     Callback::contact_destroyed, Callback::contact_ended,
                                     Callback::pair_filter, Callback::tick_before, Callback::tick_after,
                                     Callback::action, Callback::drawer, Callback::motion_state),
                     testing::Values(Call::events, Call::add, Call::make_breakable, Call::remove,
                                     Call::remove_all, Call::blow, Call::questions, Call::destroy)),
    [](const auto& info) {
        return std::string(callback_names[static_cast<int>(std::get<0>(info.param))]) + "_" +
               call_names[static_cast<int>(std::get<1>(info.param))];
    });

TEST(Callbacks, SecondHookIsInsideTheStepAsLongAsTheFirst) {
    // The outer hook's fragments collide after the inner hook is done with its part of the step.
    Stage stage(Callback::near);
    FractureWorld outer(stage.scene.world.get());
    const BreakableAsset asset = plate(crumbly(), 0.1);
    ASSERT_TRUE(outer.add(asset, at(0, -3, 0)).ok());
    stage.scene.addBall(2, 0.1, btVector3(0.05f, -3, 0.15f), btVector3(0, 0, -8));
    int calls = 0;
    task() = [&] {
        ++calls;
        EXPECT_FALSE(stage.fracture->add(asset, at(10, 10, 10)).ok());
        EXPECT_FALSE(outer.add(asset, at(10, 10, 10)).ok());
    };
    stage.run();
    task() = nullptr;
    EXPECT_GT(calls, 0);
    EXPECT_GT(outer.bodies().size(), 1u);
    EXPECT_GT(stage.fracture->bodies().size(), 1u);
}

TEST(Callbacks, BodiesOfEventsTakenInsideAStepLiveUntilTheNext) {
    Stage stage(Callback::near);
    int reads = 0;
    std::vector<BlowEvent> taken;
    task() = [&] {
        for (BlowEvent& event : stage.fracture->takeEvents()) taken.push_back(std::move(event));
    };
    for (int i = 0; i < 30; ++i) {
        taken.clear();
        stage.run(1);
        for (const BlowEvent& event : taken) {
            if (event.outcome != broke) continue;
            ++reads;
            EXPECT_NE(event.body->getInvMass(), 0) << "the body that the event names was deleted in its step";
            EXPECT_NE(stage.scene.world->getNumCollisionObjects(), 0);
        }
    }
    EXPECT_EQ(reads, 1);
}

TEST(Callbacks, RemoveOfABodyThatHasJustBrokenRemovesItsPieces) {
    Stage stage(Callback::near);
    btRigidBody* const whole = stage.plate_body;
    int calls = 0;
    task() = [&] {
        if (calls > 0 || stage.fracture->asset(whole)) return;  // not broken yet
        ++calls;
        stage.fracture->remove(whole);
    };
    stage.run();
    EXPECT_EQ(calls, 1) << "no collisions of the pieces in the step of the break";
    EXPECT_TRUE(stage.fracture->bodies().empty());
    EXPECT_EQ(stage.scene.world->getNumCollisionObjects(), stage.own_objects);
    const auto events = stage.fracture->takeEvents();
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].outcome, broke);
    EXPECT_TRUE(events[0].fragments.empty());
}

}  // namespace
