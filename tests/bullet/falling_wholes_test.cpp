// Whole bodies that fall on the ground and stay whole.

#include <algorithm>

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

/// No box, so it collides as a hull.
TriangleMesh tile(double size) {
    TriangleMesh mesh = shapes::slab(Vec3(size, size, 0.3 * size), 2, 2, 1);
    for (Vec3& vertex : mesh.vertices)
        if (vertex.z() > 0) vertex.head<2>() *= 0.97;
    return mesh;
}

enum class Ground { box, plane };

class FallingWholes : public testing::TestWithParam<Ground> {
  protected:
    FallingWholes() {
        scene_.world->setGravity(btVector3(0, 0, -9.81f));
        if (GetParam() == Ground::box) scene_.addFloor();
        if (GetParam() == Ground::plane)
            scene_.addBody(std::make_unique<btStaticPlaneShape>(btVector3(0, 0, 1), btScalar(0)), 0,
                           btVector3(0, 0, 0));
    }

    TestWorld scene_;
};

/// In a step of 1/60 s they fall by more than they are thick, and Bullet has one contact of a hull a step:
/// they turned by a radian in the next one, and sank by twice their size.
TEST_P(FallingWholes, DoNotSinkAt60StepsASecond) {
    for (const double size : {0.1, 0.03}) {
        FractureWorld fracture(scene_.world.get());
        const auto asset =
            BreakableAsset::fromMesh(tile(size), unbreakable(), Settings::forQuality(Quality::preview));
        ASSERT_TRUE(asset.ok()) << asset.error();
        for (int k = 0; k < 20; ++k) {
            BodyOptions options;
            options.start = btTransform(
                btQuaternion(btVector3(1, 0.3f * btScalar(k), 0.2f).normalized(), 0.37f * btScalar(k)),
                btVector3(0.9f * btScalar(k % 5 - 2), 0.9f * btScalar(k / 5 - 2), 1));
            ASSERT_TRUE(fracture.add(asset.value(), options).ok());
        }
        scene_.step(240, 1.0 / 60);
        for (const btRigidBody* body : fracture.bodies()) {
            double lowest = 1;
            for (const Vec3& vertex : asset.value().surface().vertices) {
                const btVector3 place =
                    fracture.assetTransform(body) *
                    btVector3(btScalar(vertex.x()), btScalar(vertex.y()), btScalar(vertex.z()));
                lowest = std::min(lowest, double(place.z()));
            }
            EXPECT_GT(lowest, -0.2 * size);
            EXPECT_LT(lowest, 0.1 * size);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(OnGround, FallingWholes, testing::Values(Ground::box, Ground::plane));

}  // namespace
