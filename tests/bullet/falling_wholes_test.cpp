// Whole bodies that fall on the ground and stay whole.

#include <algorithm>

#include "bullet/energy.h"
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

enum class Ground { box, plane, mesh, lift, crate };

/// Twenty tiles that stay whole, 1 m above the ground, each turned another way.
BreakableAsset addTiles(FractureWorld& fracture, double size) {
    const auto asset =
        BreakableAsset::fromMesh(tile(size), unbreakable(), Settings::forQuality(Quality::preview));
    EXPECT_TRUE(asset.ok()) << asset.error();
    for (int k = 0; k < 20; ++k) {
        const BodyOptions options(btTransform(
            btQuaternion(btVector3(1, 0.3f * btScalar(k), 0.2f).normalized(), 0.37f * btScalar(k)),
            btVector3(0.9f * btScalar(k % 5 - 2), 0.9f * btScalar(k / 5 - 2), 1)));
        EXPECT_TRUE(fracture.add(asset.value(), options).ok());
    }
    return asset.value();
}

class FallingWholes : public testing::TestWithParam<Ground> {
  protected:
    FallingWholes() {
        scene_.world->setGravity(btVector3(0, 0, -9.81f));
        if (GetParam() == Ground::box) scene_.addFloor();
        if (GetParam() == Ground::lift) {
            btRigidBody* lift = scene_.addFloor();
            lift->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
            lift->setActivationState(DISABLE_DEACTIVATION);
        }
        if (GetParam() == Ground::crate) {
            scene_.addBox(0, btVector3(6, 6, 0.5f), btVector3(0, 0, -1.5f));
            scene_.addBox(1000, btVector3(5, 5, 0.5f), btVector3(0, 0, -0.5f));
        }
        if (GetParam() == Ground::plane)
            scene_.addBody(std::make_unique<btStaticPlaneShape>(btVector3(0, 0, 1), btScalar(0)), 0,
                           btVector3(0, 0, 0));
        if (GetParam() == Ground::mesh) {
            const btVector3 a(-20, -20, 0), b(20, -20, 0), c(20, 20, 0), d(-20, 20, 0);
            triangles_.addTriangle(a, b, c);
            triangles_.addTriangle(a, c, d);
            scene_.addBody(std::make_unique<btBvhTriangleMeshShape>(&triangles_, true), 0,
                           btVector3(0, 0, 0));
        }
    }

    btTriangleMesh triangles_;
    TestWorld scene_;
};

/// In a step of 1/60 s they fall by more than they are thick, and Bullet has one contact of a hull a step:
/// they turned by a radian in the next one, and sank by twice their size.
TEST_P(FallingWholes, DoNotSinkAt60StepsASecond) {
    for (const double size : {0.1, 0.03}) {
        FractureWorld fracture(scene_.world.get());
        const BreakableAsset asset = addTiles(fracture, size);
        scene_.step(240, 1.0 / 60);
        for (const btRigidBody* body : fracture.bodies()) {
            double lowest = 1;
            for (const Vec3& vertex : asset.surface().vertices) {
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

class FallingOnASurface : public FallingWholes {};

/// Small ones are through it in a step, and are set back onto it. Out of what is solid Bullet lifts them.
TEST_P(FallingOnASurface, GainsNoEnergyWhereItIsSetBack) {
    FractureWorld fracture(scene_.world.get());
    addTiles(fracture, 0.03);
    const double whole = energyOf(fracture.bodies());
    double before = whole;
    for (int step = 0; step < 120; ++step) {
        scene_.step(1, 1.0 / 60);
        const double now = energyOf(fracture.bodies());
        EXPECT_LT(now, before + 0.001 * whole) << "step " << step;
        before = now;
    }
}

/// On a slope, which is at right angles to no axis.
TEST_P(FallingOnASurface, IsNotSlowedAlongALockedAxis) {
    scene_.bodies.front()->setWorldTransform(btTransform(btQuaternion(btVector3(0, 1, 0), 0.3f)));
    FractureWorld fracture(scene_.world.get());
    addTiles(fracture, 0.03);
    for (btRigidBody* body : fracture.bodies()) body->setLinearFactor(btVector3(0, 1, 1));
    scene_.step(60, 1.0 / 60);
    for (const btRigidBody* body : fracture.bodies()) EXPECT_EQ(body->getLinearVelocity().x(), 0);
}

INSTANTIATE_TEST_SUITE_P(OnGround, FallingWholes,
                         testing::Values(Ground::box, Ground::plane, Ground::mesh, Ground::lift,
                                         Ground::crate));
INSTANTIATE_TEST_SUITE_P(OnAMesh, FallingOnASurface, testing::Values(Ground::mesh));

}  // namespace
