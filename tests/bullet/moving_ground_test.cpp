// Pieces on ground that is not static: lifts, crates, tables. They fell through it, or fell asleep inside.

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

enum class Ground { lift, rising_lift, crate, breakable_top };

class PiecesOn : public testing::TestWithParam<Ground> {
  protected:
    PiecesOn() { scene_.world->setGravity(btVector3(0, 0, -9.81f)); }

    /// Its top is at z = 0, and nothing else catches what falls through it.
    btRigidBody* addGround(FractureWorld& fracture) {
        if (GetParam() == Ground::breakable_top) {
            scene_.addBox(0, btVector3(1, 1, 0.5f), btVector3(0, 0, -0.9f));
            const auto slab = BreakableAsset::fromMesh(shapes::box(Vec3(-1, -1, -0.4), Vec3(1, 1, 0)),
                                                       unbreakable(), coarse(0.2));
            return fracture.add(slab.value(), btTransform::getIdentity()).value();
        }
        const bool is_crate = GetParam() == Ground::crate;
        if (is_crate) scene_.addBox(0, btVector3(1, 1, 0.5f), btVector3(0, 0, -0.9f));
        btRigidBody* ground =
            scene_.addBox(is_crate ? 100 : 0, btVector3(1, 1, 0.2f), btVector3(0, 0, -0.2f));
        if (!is_crate) {
            ground->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
            ground->setActivationState(DISABLE_DEACTIVATION);
        }
        return ground;
    }

    TestWorld scene_;
};

TEST_P(PiecesOn, LieOnItAtAnyRate) {
    Settings settings = Settings::forQuality(Quality::preview);
    settings.fracture.fragment_count = 12;
    const auto bowl =
        BreakableAsset::fromMesh(shapes::bowl(0.06, 0.006, 24, 8), Material::ceramic(), settings);
    ASSERT_TRUE(bowl.ok()) << bowl.error();
    for (const double rate_hz : {60.0, 120.0, 240.0}) {
        FractureWorld fracture(scene_.world.get());
        btRigidBody* ground = addGround(fracture);
        for (int i = 0; i < 3; ++i)
            ASSERT_TRUE(
                fracture
                    .add(bowl.value(), btTransform(btQuaternion(btVector3(0, 1, 0), 2.2f + btScalar(i)),
                                                   btVector3(0.3f * btScalar(i - 1), 0, 1.2f)))
                    .ok());
        const int steps = static_cast<int>(4 * rate_hz);
        for (int i = 0; i < steps; ++i) {
            if (GetParam() == Ground::rising_lift && i > steps / 2)
                ground->getWorldTransform().getOrigin().setZ(
                    btScalar(-0.2 + 0.5 * (i - steps / 2) / rate_hz));
            scene_.step(1, 1 / rate_hz);
        }
        const double top =
            ground->getWorldTransform().getOrigin().z() + (GetParam() == Ground::breakable_top ? 0.2 : 0.2);
        int pieces = 0, on_it = 0;
        for (const btRigidBody* body : fracture.bodies()) {
            if (body == ground) continue;
            const btVector3 place = body->getWorldTransform().getOrigin();
            if (std::max(std::abs(place.x()), std::abs(place.y())) > 1) continue;  // rolled off
            ++pieces;
            on_it += place.z() > top - 0.002;
        }
        EXPECT_GT(pieces, 20) << rate_hz;
        EXPECT_EQ(on_it, pieces) << rate_hz;
        if (GetParam() == Ground::breakable_top) fracture.remove(ground);
        for (auto& body : scene_.bodies) scene_.world->removeRigidBody(body.get());
        scene_.bodies.clear();
    }
}

INSTANTIATE_TEST_SUITE_P(ThatIsNotStatic, PiecesOn,
                         testing::Values(Ground::lift, Ground::rising_lift, Ground::crate,
                                         Ground::breakable_top));

}  // namespace
