// Where nothing breaks, the hook must not be felt: the same bits as plain Bullet.

#include "bullet/support.h"
#include "fracture/pipeline.h"
#include "support/plain_twin.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

struct Case {
    const char* name;
    WorldKind kind;
    int solver_mode_off;  // bits taken out of the solver mode in the middle of the run
    bool split_impulse;

    friend void PrintTo(const Case& self, std::ostream* out) { *out << self.name; }
};

class PlainEquality : public testing::TestWithParam<Case> {
  protected:
    static void set(TestWorld& scene) {
        scene.world->setGravity(btVector3(0, 0, -9.81f));
        scene.world->getSolverInfo().m_splitImpulse = GetParam().split_impulse;
        scene.addFloor();
    }

    /// Two worlds side by side, a ball thrown at a plate that stands on the floor; the left one is hooked.
    static void compare(const Material& material, BlowCounts& counts) {
        TestWorld hooked(GetParam().kind), plain(GetParam().kind);
        set(hooked);
        set(plain);
        const BreakableAsset asset = plate(material);
        const btTransform standing(btQuaternion(btVector3(1, 0, 0), SIMD_HALF_PI), btVector3(0, 0, 0.301f));

        FractureWorld fracture(hooked.world.get());
        btRigidBody* body = fracture.add(asset, standing).value();

        OwnedBody twin = plainTwin(*asset.solid(), ShapeChoice(asset.settings().fracture));
        twin.body->setCenterOfMassTransform(
            standing * principalFrame(asset.solid()->moments()).body_from_asset.inverse());
        plain.world->addRigidBody(twin.body.get());

        btRigidBody* ball = hooked.addBall(3, 0.1, btVector3(0, 0.3f, 0.4f), btVector3(0, -6, 0));
        btRigidBody* plain_ball = plain.addBall(3, 0.1, btVector3(0, 0.3f, 0.4f), btVector3(0, -6, 0));
        for (int i = 0; i < 480; ++i) {
            if (i == 30) {  // in contact already, so that impulses of the other mode are about
                hooked.world->getSolverInfo().m_solverMode &= ~GetParam().solver_mode_off;
                plain.world->getSolverInfo().m_solverMode &= ~GetParam().solver_mode_off;
            }
            hooked.step();
            plain.step();
            ASSERT_TRUE(sameState(*body, *twin.body)) << "plate, step " << i;
            ASSERT_TRUE(sameState(*ball, *plain_ball)) << "ball, step " << i;
        }
        for (const BlowEvent& event : fracture.takeEvents()) EXPECT_EQ(event.outcome, Outcome::held);
        counts = fracture.counts();
        plain.world->removeRigidBody(twin.body.get());
    }
};

TEST_P(PlainEquality, WhereTheBoundSaysThatNothingCanBreak) {
    BlowCounts counts;
    compare(unbreakable(), counts);
    EXPECT_EQ(counts.seen, 0) << "all that moves has too little energy";

    Material strong = Material::plaster();
    strong.tensile_strength_pa = 1.5e8;
    strong.strength_scatter = 0;
    compare(strong, counts);
    EXPECT_EQ(counts.solved(), 0);
    EXPECT_GT(counts.seen, 0);
    EXPECT_EQ(counts.gate, counts.seen);
}

TEST_P(PlainEquality, WhereBlowsAreSolvedAndHeld) {
    Material tough = Material::plaster();
    tough.tensile_strength_pa = 4e7;
    BlowCounts counts;
    compare(tough, counts);
    EXPECT_GT(counts.solved(), 0) << "the strength of this test is to let the bound pass";
}

constexpr int warm = SOLVER_USE_WARMSTARTING;
INSTANTIATE_TEST_SUITE_P(Worlds, PlainEquality,
                         testing::Values(Case{"plain", WorldKind::plain, 0, true},
                                         Case{"no_warm_starting", WorldKind::plain, warm, true},
                                         Case{"no_split_impulse", WorldKind::plain, 0, false},
                                         Case{"owns_its_solver", WorldKind::owns_its_solver, 0, true},
                                         Case{"threaded", WorldKind::threaded, 0, true},
                                         Case{"soft", WorldKind::soft, 0, true},
                                         Case{"multi_body", WorldKind::multi_body, 0, true}),
                         [](const auto& info) { return info.param.name; });

TEST(Rest, BodyAtRestCostsNoSolveForTenSeconds) {
    TestWorld scene;
    scene.world->setGravity(btVector3(0, 0, -9.81f));
    scene.addFloor();
    FractureWorld fracture(scene.world.get());
    btRigidBody* body = fracture.add(plate(Material::plaster()), at(0, 0, 0.031f)).value();
    body->setActivationState(
        DISABLE_DEACTIVATION);  // or Bullet would put it to sleep and nothing would be tested
    scene.step(240);            // comes to rest
    const BlowCounts resting = fracture.counts();
    scene.step(1200);
    EXPECT_EQ(fracture.counts().seen, resting.seen) << "nothing in the world could break it";
    btRigidBody* passing = scene.addBall(100, 0.1, btVector3(0, 0, 3), btVector3(5, 0, 0));
    passing->setGravity(btVector3(0, 0, 0));
    const BlowCounts landed = fracture.counts();
    scene.step(1200);
    EXPECT_EQ(fracture.counts().seen, landed.seen) << "what passes by does not make rest a blow";
}

TEST(Rest, SleepingBodyIsNotEvenSeen) {
    TestWorld scene;
    scene.world->setGravity(btVector3(0, 0, -9.81f));
    scene.addFloor();
    FractureWorld fracture(scene.world.get());
    btRigidBody* body = fracture.add(plate(Material::plaster()), at(0, 0, 0.031f)).value();
    scene.step(1200);
    ASSERT_FALSE(body->isActive());
    const long long seen = fracture.counts().seen;
    scene.addBall(1, 0.1, btVector3(0, 3, 1));  // keeps the world awake
    scene.step(100);
    EXPECT_EQ(fracture.counts().seen, seen);
}

}  // namespace
