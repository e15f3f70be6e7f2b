// A body of 20 m or 3 mm is a slip of the exporter: the first blow on it says so, whatever comes of the blow.

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

/// A cube of this size that moves against a body a ten-thousandth of its own size away.
std::vector<BlowEvent> eventsOfACube(double size_m, double speed_m_s, const Material& material) {
    Settings settings = coarse(size_m / 5);
    settings.fracture.smallest_fragment_m3 = 0;
    const auto asset = BreakableAsset::fromMesh(shapes::box(Vec3(0, 0, 0), Vec3(size_m, size_m, size_m)),
                                                material, settings);
    EXPECT_TRUE(asset.ok()) << asset.error();
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    const double half = 5 * size_m;
    scene.addBox(0, btVector3(btScalar(half), btScalar(half), btScalar(half)),
                 btVector3(0, 0, btScalar(-half - size_m / 10000)));
    fracture.add(asset.value(), at(0, 0, 0))
        .value()
        ->setLinearVelocity(btVector3(0, 0, btScalar(-speed_m_s)));
    std::vector<BlowEvent> events;
    for (int i = 0; i < 60; ++i) {
        scene.step();
        for (BlowEvent& event : fracture.takeEvents()) events.push_back(std::move(event));
    }
    return events;
}

bool warns(const BlowEvent& event) {
    return warnsOf(event, "Repair::scale");
}

TEST(SizeWarning, FirstBlowOnAHugeBodySaysIt) {
    const std::vector<BlowEvent> events = eventsOfACube(20, 10, crumbly());
    ASSERT_FALSE(events.empty());
    EXPECT_EQ(events[0].outcome, Outcome::broke) << events[0].message;
    EXPECT_TRUE(warnsOf(events[0], "20 m long"));
    for (std::size_t i = 1; i < events.size(); ++i) EXPECT_FALSE(warns(events[i])) << "event " << i;
}

TEST(SizeWarning, FirstBlowOnATinyBodySaysItThoughItIsTooWeakToBeSolved) {
    const std::vector<BlowEvent> events = eventsOfACube(0.003, 1, unbreakable());
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].outcome, Outcome::held);
    EXPECT_TRUE(warnsOf(events[0], "0.003 m long"));
    EXPECT_GT(events[0].normal.z(), 0.9);
}

TEST(SizeWarning, AfterItsEventABodyAtRestIsNoLongerLookedAt) {
    Settings settings = coarse(0.001);
    settings.fracture.smallest_fragment_m3 = 0;
    const auto asset = BreakableAsset::fromMesh(shapes::box(Vec3(0, 0, 0), Vec3(0.004, 0.004, 0.004)),
                                                unbreakable(), settings);
    ASSERT_TRUE(asset.ok()) << asset.error();
    ASSERT_FALSE(asset.value().warnings().empty());
    TestWorld scene;
    scene.addFloor();
    scene.world->setGravity(btVector3(0, 0, -10));
    FractureWorld fracture(scene.world.get());
    btRigidBody* body = fracture.add(asset.value(), at(0, 0, 0.0001f)).value();
    body->setActivationState(DISABLE_DEACTIVATION);
    scene.step(30);
    const auto events = fracture.takeEvents();
    ASSERT_EQ(events.size(), 1u);
    EXPECT_TRUE(warns(events[0]));
    const long long seen = fracture.counts().seen;
    scene.step(30);
    EXPECT_EQ(fracture.counts().seen, seen);
}

TEST(SizeWarning, UsualBodiesAndTheirFragmentsGoWithout) {
    const std::vector<BlowEvent> events = eventsOfACube(0.02, 10, crumbly());
    ASSERT_FALSE(events.empty());
    EXPECT_EQ(events[0].outcome, Outcome::broke) << events[0].message;
    for (const BlowEvent& event : events) EXPECT_FALSE(warns(event));
}

}  // namespace
