// What becomes of a scene's bodies before they are struck.
#include "world/scene_world.h"

#include <gtest/gtest.h>

#include "scenes/box_mesh.h"
#include "support/temporary_path.h"

namespace {

using demo::Vec3;

demo::Scene plasterBox() {
    demo::Scene scene;
    demo::BreakableBody body;
    body.shape = demo::Box{Vec3(1, 0.1, 1), 0.25};
    body.material = sherd::Material::plaster();
    scene.bodies = {body};
    return scene;
}

/// A box from an OBJ, black on the left, white on the right.
std::string paintedObj() {
    sherd::TriangleMesh mesh = demo::boxMesh({Vec3(1, 0.1, 1), 0.25});
    for (const Vec3& vertex : mesh.vertices)
        mesh.colours.push_back(vertex.x() < 0 ? Vec3::Zero() : Vec3::Ones());
    const std::string path = temporaryPath("painted_box.obj");
    EXPECT_TRUE(sherd::writeObj(mesh, path).ok());
    return path;
}

sherd::Result<demo::SceneAssets> assetsOf(const demo::Scene& scene) {
    return demo::makeAssets(scene, SHERD_MESHES, [](const std::string&) {});
}

TEST(SceneWorld, ASolidThatCannotBeSampledIsRefusedWithTheReason) {
    demo::Scene scene = plasterBox();
    scene.bodies[0].settings.sampling.spacing_m = 1e-4;
    const auto assets = assetsOf(scene);
    ASSERT_FALSE(assets.ok());
    EXPECT_NE(assets.error().find("use a spacing of at least"), std::string::npos) << assets.error();
}

TEST(SceneWorld, ABodyWithSupportsStandsAndItsPiecesThereStay) {
    demo::Scene scene = plasterBox();
    scene.bodies[0].position = Vec3(0, 0, 1);
    scene.bodies[0].supports = {sherd::BoxRegion{{-1, -1, -0.5}, {1, 1, -0.5}}};
    demo::Ball ball;
    ball.position = Vec3(0, -0.9, 1.5);
    ball.velocity = Vec3(0, 8, 0);
    scene.balls = {ball};
    const auto assets = assetsOf(scene);
    ASSERT_TRUE(assets.ok()) << assets.error();
    demo::SceneWorld world(scene, assets.value());
    for (int step = 0; step < 20; ++step) world.step();
    ASSERT_EQ(world.fracture().bodies().size(), 1u);
    EXPECT_TRUE(world.fracture().bodies()[0]->isStaticObject()) << "it hangs in the air and stays";
    for (int step = 0; step < 60; ++step) world.step();
    int held = 0, moving = 0;
    for (const btRigidBody* piece : world.fracture().bodies()) ++(piece->isStaticObject() ? held : moving);
    EXPECT_GT(held, 0);
    EXPECT_GT(moving, 0);
}

TEST(SceneWorld, SupportsThatHoldNothingAreRefusedWithTheReason) {
    demo::Scene scene = plasterBox();
    scene.bodies[0].supports = {sherd::BoxRegion{{-1, -1, 5}, {1, 1, 5}}};
    const auto assets = assetsOf(scene);
    ASSERT_FALSE(assets.ok());
    EXPECT_EQ(assets.error().find("A support cannot be placed: No part"), 0u) << assets.error();
}

TEST(SceneWorld, PaintedStrengthNeedsColours) {
    demo::Scene scene = plasterBox();
    scene.bodies[0].painted_strength.emplace();
    const auto assets = assetsOf(scene);
    ASSERT_FALSE(assets.ok());
    EXPECT_EQ(assets.error().find("painted_strength: The mesh has no vertex colours"), 0u) << assets.error();
}

/// Bodies after a ball struck the middle of a wall that is painted black on one half.
std::size_t bodiesAfterABlow(const std::optional<demo::PaintedStrength>& painted) {
    demo::Scene scene = plasterBox();
    scene.bodies[0].shape = demo::ObjFile{paintedObj()};
    scene.bodies[0].painted_strength = painted;
    demo::Ball ball;
    ball.position = Vec3(0, -0.16, 0.5);
    ball.velocity = Vec3(0, 6, 0);
    scene.balls = {ball};
    const auto assets = assetsOf(scene);
    EXPECT_TRUE(assets.ok()) << assets.error();
    demo::SceneWorld world(scene, assets.value());
    for (int step = 0; step < 10; ++step) world.step();
    return world.fracture().bodies().size();
}

TEST(SceneWorld, PaintedStrengthReachesTheFracture) {
    const std::size_t plain = bodiesAfterABlow(std::nullopt);
    EXPECT_GT(plain, 1u);
    EXPECT_EQ(bodiesAfterABlow(demo::PaintedStrength{1, 1}), plain);
    EXPECT_EQ(bodiesAfterABlow(demo::PaintedStrength{1000, 1000}), 1u);
}

}  // namespace
