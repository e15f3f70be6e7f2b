// What hands do to a scene.
#include "viewer/simulation.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "viewer/stress_view.h"

namespace {

using demo::Simulation;

/// A wall of plaster that stands on the floor, about the origin.
demo::Scene plasterWall() {
    demo::Scene scene;
    demo::BreakableBody body;
    body.shape = demo::Box{demo::Vec3(1, 0.1, 1), 0.25};
    body.material = sherd::Material::plaster();
    body.settings = sherd::Settings::forQuality(sherd::Quality::preview);
    scene.bodies = {body};
    return scene;
}

demo::SceneAssets assetsOf(const demo::Scene& scene) {
    auto assets = demo::makeAssets(scene, "", [](const std::string&) {});
    EXPECT_TRUE(assets.ok()) << assets.error();
    return std::move(assets).value();
}

render::Ray rayAt(const render::Vec3& target) {
    const render::Vec3 eye(0.5f, -4, 1);
    return {eye, (target - eye).normalized()};
}

struct SimulationTest : testing::Test {
    demo::Scene scene = plasterWall();
    demo::SceneAssets assets = assetsOf(scene);
    Simulation simulation{scene, assets};

    void step(int count) {
        for (int i = 0; i < count; ++i) simulation.stepOnce();
    }
};

TEST_F(SimulationTest, ABallThatIsThrownSlowlyComesDownWhereTheRayLeads) {
    const render::Vec3 target(0.2f, -0.05f, 0.6f);
    simulation.throwBall(rayAt(target), {4, 0.05});
    const btRigidBody* ball = simulation.placed().balls().front().body;
    float nearest = 10;
    for (int i = 0; i < 150; ++i) {
        step(1);
        const btVector3 at = ball->getWorldTransform().getOrigin();
        nearest = std::min(nearest, (render::Vec3(at.x(), at.y(), at.z()) - target).norm());
    }
    EXPECT_LT(nearest, 0.05f);  // the radius, and a little for the step
}

TEST_F(SimulationTest, AHeldBodyFollowsTheMouseAndIsLetGoWhenItBreaks) {
    step(5);
    ASSERT_TRUE(simulation.drag().take(rayAt({0, 0, 0.9f})));
    simulation.drag().moveTo(rayAt({0, 0, 1.5f}));
    step(60);
    EXPECT_GT(simulation.placed().fracture().bodies().front()->getWorldTransform().getOrigin().z(), 0.55f);
    simulation.throwBall(rayAt({0, 0, 0.7f}), {30, 0.2});
    step(60);
    EXPECT_GT(simulation.breaks(), 0);
    EXPECT_FALSE(simulation.drag().holding());
}

TEST_F(SimulationTest, TheFloorIsNotHeld) {
    EXPECT_FALSE(simulation.drag().take(rayAt({0.5f, -2, 0})));
}

TEST_F(SimulationTest, TheStressOfABlowIsKnownParticleByParticleAndSoAreThePieces) {
    step(5);
    simulation.throwBall(rayAt({0, 0, 0.5f}), {20, 0.2});
    for (int i = 0; i < 60 && simulation.breaks() == 0; ++i) step(1);
    ASSERT_GT(simulation.breaks(), 0);
    demo::StressView view;
    view.want(*simulation.lastBlow());
    view.wait();
    const auto& stress = view.newest();
    ASSERT_TRUE(stress && stress->error.empty()) << (stress ? stress->error : "");
    EXPECT_EQ(int(stress->particles.size()), assets.bodies.front().particleCount());
    EXPECT_GT(stress->largest_pa, stress->strength_pa);
    const auto placed = std::count_if(stress->particles.begin(), stress->particles.end(),
                                      [](const auto& particle) { return particle.piece >= 0; });
    EXPECT_GT(double(placed), 0.9 * double(stress->particles.size()));
}

}  // namespace
