// What becomes of a scene's bodies before they are struck.
#include "headless/scene_world.h"

#include <gtest/gtest.h>

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

sherd::Result<std::vector<sherd::BreakableAsset>> assetsOf(const demo::Scene& scene) {
    return demo::makeAssets(scene, SHERD_MESHES, [](const std::string&) {});
}

TEST(SceneWorld, ASolidThatCannotBeSampledIsRefusedWithTheReason) {
    demo::Scene scene = plasterBox();
    scene.bodies[0].settings.sampling.spacing_m = 1e-4;
    const auto assets = assetsOf(scene);
    ASSERT_FALSE(assets.ok());
    EXPECT_NE(assets.error().find("use a spacing of at least"), std::string::npos) << assets.error();
}

}  // namespace
