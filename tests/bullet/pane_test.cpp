// Thin panes whose shape is made of boxes: these lie where the pane is.

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

constexpr btScalar thickness_m = btScalar(0.01);

/// 0.6 x 0.6 m in the x-y plane about the origin.
BreakableAsset pane(const Material& material) {
    Settings settings = Settings::forQuality(Quality::preview);
    settings.fracture.collision_shape = CollisionShape::boxes;
    const auto asset =
        BreakableAsset::fromMesh(shapes::slab(Vec3(0.6, 0.6, double(thickness_m))), material, settings);
    EXPECT_TRUE(asset.ok()) << asset.error();
    return asset.value();
}

TEST(Pane, ABallRestsOnBothFacesAtTheSameDistance) {
    double height_m[2];
    for (const int face : {0, 1}) {
        const btScalar up = face == 0 ? btScalar(1) : btScalar(-1);
        TestWorld scene;
        scene.world->setGravity(btVector3(0, 0, -10 * up));
        FractureWorld fracture(scene.world.get());
        btRigidBody* const body = fracture.add(pane(unbreakable()), at(0, 0, 0)).value();
        body->setLinearFactor(btVector3(0, 0, 0));
        body->setAngularFactor(btVector3(0, 0, 0));
        btRigidBody* const ball = scene.addBall(0.1, 0.05, btVector3(0.03f, 0.02f, up * 0.057f));
        // Led along a line: under a plain box, too, Bullet's contact is tilted enough for a ball to roll
        // away.
        ball->setLinearFactor(btVector3(0, 0, 1));
        ball->setAngularFactor(btVector3(0, 0, 0));
        scene.step(480);
        EXPECT_LT(ball->getLinearVelocity().length(), 0.01);
        height_m[face] = up * ball->getCenterOfMassPosition().z() - thickness_m / 2;
        EXPECT_NEAR(height_m[face], 0.05, 1e-3);
    }
    EXPECT_NEAR(height_m[0], height_m[1], 1e-3);
}

TEST(Pane, InASlotIsNotSolvedOverAndOver) {
    for (const double hz : {60., 240.}) {
        TestWorld scene;
        scene.world->setGravity(btVector3(0, 0, -10));
        scene.addFloor();
        const btScalar gap = btScalar(0.0005);
        for (const btScalar side : {btScalar(-1), btScalar(1)})
            scene.addBox(0, btVector3(0.4f, 0.05f, 0.05f),
                         btVector3(0, side * (thickness_m / 2 + gap + btScalar(0.05)), 0.05f));
        FractureWorld fracture(scene.world.get());
        const btTransform upright(btQuaternion(btVector3(1, 0, 0), SIMD_HALF_PI), btVector3(0, 0, 0.3f));
        ASSERT_TRUE(fracture.add(pane(Material::glass()), upright).ok());
        scene.step(int(2 * hz), 1 / hz);
        EXPECT_EQ(fracture.counts().solved(), 0u) << hz;
        EXPECT_EQ(fracture.bodies().size(), 1u);
    }
}

}  // namespace
