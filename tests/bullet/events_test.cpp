// What an event says of a body that is gone, and how long events and bodies wait.

#include <algorithm>

#include "bullet/bodies/event_queue.h"
#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

TEST(Events, CarryTheAssetAndWhereItStoodWhenTheBlowFell) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    BodyOptions options(btTransform(btQuaternion(btVector3(1, 2, 3), 0.4f), btVector3(1, 2, 3)));
    options.velocity = btVector3(0.5f, -1, 0.25f);
    options.angular_velocity = btVector3(0.3f, 0.2f, 1);
    options.name = "pane";
    // A plate whose centre of mass is not the origin of its coordinates.
    const auto asset = BreakableAsset::fromMesh(shapes::box(Vec3(0.7, -0.3, -0.03), Vec3(1.3, 0.3, 0.03)),
                                                crumbly(), coarse(0.06));
    btRigidBody* body = fracture.add(asset.value(), options).value();
    const btVector3 ahead = options.start.getBasis().getColumn(2);
    const btRigidBody* ball = scene.addBall(2, 0.1, options.start * btVector3(1, 0, 0.2f), -8 * ahead);
    btTransform stood;
    btVector3 velocity, spin;
    for (int i = 0; i < 60; ++i) {
        stood = fracture.assetTransform(body);
        velocity = body->getLinearVelocity();
        spin = body->getAngularVelocity();
        const BlowEvent event = stepUntilBreak(scene, fracture, 1);
        if (event.outcome == Outcome::held) continue;
        ASSERT_EQ(event.outcome, Outcome::broke) << event.message;
        EXPECT_EQ(event.body, body);
        EXPECT_EQ(event.name, "pane");
        EXPECT_EQ(event.asset.surface().vertices.size(), 8u);
        EXPECT_LT(event.asset_transform.getOrigin().distance(stood.getOrigin()), 1e-6);
        EXPECT_LT((event.asset_transform.getBasis()[0] - stood.getBasis()[0]).length(), 1e-6);
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(event.velocity[axis], velocity[axis], 1e-6);
            EXPECT_NEAR(event.angular_velocity[axis], spin[axis], 1e-6);
        }
        // The blow lies on the surface where that stood.
        const btVector3 there = event.asset_transform.inverse() * btVector3(btScalar(event.position.x()),
                                                                            btScalar(event.position.y()),
                                                                            btScalar(event.position.z()));
        EXPECT_NEAR(there.z(), 0.03, 0.01);
        EXPECT_EQ(event.striker, ball);
        EXPECT_EQ(event.generation, 0);
        return;
    }
    FAIL() << "nothing broke";
}

TEST(Events, SayHowManyBreaksMadeTheBody) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    Settings settings = coarse(0.06);
    settings.fracture.smallest_fragment_m3 = 3e-4;
    settings.fracture.rest_after_break_s = 0;
    const auto asset = BreakableAsset::fromMesh(shapes::box(Vec3(-0.3, -0.3, -0.03), Vec3(0.3, 0.3, 0.03)),
                                                crumbly(), settings);
    btRigidBody* body = fracture.add(asset.value()).value();
    for (int generation = 0; generation < 2; ++generation) {
        EXPECT_EQ(fracture.generation(body), generation);
        const btVector3 centre = body->getWorldTransform().getOrigin();
        ASSERT_TRUE(fracture.applyBlow(body, {centre, btVector3(0, 0, -30)}).ok());
        const auto events = fracture.takeEvents();
        ASSERT_EQ(events.size(), 1u);
        ASSERT_EQ(events[0].outcome, Outcome::broke);
        EXPECT_EQ(events[0].generation, generation);
        EXPECT_EQ(events[0].striker, nullptr) << "the app struck it itself";
        body =
            *std::max_element(events[0].fragments.begin(), events[0].fragments.end(),
                              [](const auto* a, const auto* b) { return a->getInvMass() > b->getInvMass(); });
    }
}

TEST(Events, NobodyTakesThemSoTheOldestAreDroppedWithTheirBodies) {
    const BreakableAsset asset = plate(crumbly());
    EventQueue queue;
    std::weak_ptr<const FractureSettings> first, last;
    for (int i = 0; i < 1003; ++i) {
        QueuedEvent queued{BlowEvent(asset), nullptr};
        queued.event.outcome = Outcome::broke;
        queued.event.impulse_n_s = i;
        if (i == 0 || i == 1002) {
            const auto settings = std::make_shared<const FractureSettings>();
            (i == 0 ? first : last) = settings;
            queued.broken = std::make_unique<Breakable>(asset, settings);
        }
        queue.push(std::move(queued));
    }
    EXPECT_EQ(queue.dropped(), 3);
    EXPECT_FALSE(first.expired()) << "alive until the next solve";
    queue.deleteReleased();
    EXPECT_TRUE(first.expired());
    const std::vector<BlowEvent> events = queue.take();
    ASSERT_EQ(events.size(), 1000u);
    EXPECT_EQ(events.front().impulse_n_s, 3);
    EXPECT_EQ(events.back().impulse_n_s, 1002);
    EXPECT_FALSE(last.expired());
    queue.deleteReleased();
    EXPECT_TRUE(last.expired());
    EXPECT_TRUE(queue.take().empty());
}

TEST(Events, BlowsThatTheBudgetDroppedCrowdOutNoBreak) {
    const BreakableAsset asset = plate(crumbly());
    EventQueue queue;
    for (int i = 0; i < 5000; ++i) {
        QueuedEvent queued{BlowEvent(asset), nullptr};
        queued.event.outcome = i % 100 == 0   ? Outcome::broke
                               : i % 100 == 1 ? Outcome::failed
                               : i % 4 == 0   ? Outcome::held
                                              : Outcome::dropped;
        queued.event.impulse_n_s = i;
        queue.push(std::move(queued));
    }
    EXPECT_EQ(queue.dropped(), 4000);
    const std::vector<BlowEvent> events = queue.take();
    ASSERT_EQ(events.size(), 1000u);
    const auto those = [&](Outcome outcome) {
        return std::count_if(events.begin(), events.end(),
                             [&](const BlowEvent& event) { return event.outcome == outcome; });
    };
    EXPECT_EQ(those(Outcome::broke), 50);
    EXPECT_EQ(those(Outcome::failed), 50);
    for (int i = 0; i < 1001; ++i) {
        QueuedEvent queued{BlowEvent(asset), nullptr};
        queued.event.outcome = i < 1000 ? Outcome::broke : Outcome::held;
        queue.push(std::move(queued));
    }
    for (const BlowEvent& event : queue.take()) EXPECT_EQ(event.outcome, Outcome::broke);
    for (std::size_t i = 1; i < events.size(); ++i)
        EXPECT_LT(events[i - 1].impulse_n_s, events[i].impulse_n_s) << "in order";
}

}  // namespace
