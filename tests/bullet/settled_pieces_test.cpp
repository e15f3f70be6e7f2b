// Pieces that the solver pushes about where they are.

#include <BulletCollision/CollisionDispatch/btGhostObject.h>

#include <algorithm>
#include <random>
#include <utility>

#include "bullet/support.h"
#include "bullet/world/conversions.h"

extern btScalar gDeactivationTime;  // s; Bullet's

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

/// The pieces of a plate that lie apart from each other, in a world without gravity.
class SettledPieces : public testing::Test {
  protected:
    SettledPieces() : fracture_(scene_.world.get()) {
        const auto asset =
            BreakableAsset::fromMesh(shapes::slab(Vec3(0.6, 0.6, 0.03), 8, 8, 1), Material::ceramic(),
                                     Settings::forQuality(Quality::preview));
        BodyOptions options(btTransform::getIdentity());
        options.fracture = asset.value().settings().fracture;
        options.fracture->rest_after_break_s = 100;
        btRigidBody* body = fracture_.add(asset.value(), options).value();
        Push push;
        push.point = btVector3(0, 0, 0.015f);
        push.impulse_n_s = btVector3(0, 0, -20);
        push.speed_m_s = 5;
        EXPECT_TRUE(fracture_.applyBlow(body, push).ok());
        for (btRigidBody* piece : fracture_.bodies()) {
            piece->setCenterOfMassTransform(
                btTransform(btQuaternion::getIdentity(), btVector3(0, btScalar(pieces_.size()), 0)));
            piece->setAngularVelocity(btVector3(0, 0, 0));
            pieces_.push_back(piece);
        }
    }
    /// To and fro, or on and on, faster than what Bullet takes for rest.
    void move(btRigidBody& piece, bool to_and_fro, double seconds) {
        for (int step = 0; step < int(seconds * 240) && piece.isActive(); ++step) {
            piece.setLinearVelocity(btVector3(to_and_fro && step % 2 ? -1.f : 1.f, 0, 0));
            scene_.step();
        }
    }

    /// Turns to and fro on one spot; returns the speed of 5 rad/s after one step more, rad/s.
    double rock(btRigidBody& piece, const btVector3& gravity) {
        piece.setGravity(gravity);
        const auto turn = [&](btScalar speed) {
            piece.applyCentralForce(-gravity / piece.getInvMass());
            piece.setLinearVelocity(btVector3(0, 0, 0));
            piece.setAngularVelocity(btVector3(0, 0, speed));
            scene_.step(1, 1.0 / 60);
        };
        for (int step = 0; step < 40; ++step) turn(step % 2 ? 5.f : -5.f);
        turn(5);
        return piece.getAngularVelocity().z();
    }

    TestWorld scene_;
    FractureWorld fracture_;
    std::vector<btRigidBody*> pieces_;
};

TEST_F(SettledPieces, SleepWhereTheyAre) {
    ASSERT_GE(pieces_.size(), 2u);
    btRigidBody& piece = *pieces_[0];
    ASSERT_LT(piece.getLinearSleepingThreshold(), 1);
    move(piece, true, 1.9);
    EXPECT_TRUE(piece.isActive());
    move(piece, true, 0.2);
    EXPECT_FALSE(piece.isActive());
}

TEST_F(SettledPieces, StayAwakeOnTheirWay) {
    ASSERT_GE(pieces_.size(), 2u);
    move(*pieces_[0], false, 3);
    EXPECT_TRUE(pieces_[0]->isActive());
}

TEST_F(SettledPieces, HaveTimeToLeaveOnceTheyAreWokenUp) {
    ASSERT_GE(pieces_.size(), 2u);
    btRigidBody& piece = *pieces_[0];
    move(piece, true, 2.1);
    ASSERT_FALSE(piece.isActive());
    piece.activate(true);
    move(piece, true, 1.9);
    EXPECT_TRUE(piece.isActive());
}

TEST_F(SettledPieces, StayAwakeWhereTheAppWantsIt) {
    ASSERT_GE(pieces_.size(), 2u);
    pieces_[0]->setActivationState(DISABLE_DEACTIVATION);
    move(*pieces_[0], true, 3);
    EXPECT_TRUE(pieces_[0]->isActive());
}

TEST_F(SettledPieces, SpinLessAndLessWhereTheyRockOnASpot) {
    btRigidBody &piece = *pieces_[0], &swings = *pieces_[1];
    EXPECT_NEAR(rock(piece, btVector3(0, 0, 0)), 5, 1e-3) << "without gravity nothing rests";
    const double speed = rock(piece, btVector3(0, 0, -200));  // the pieces are large
    EXPECT_LT(speed, 4.9);
    EXPECT_GT(speed, 3);
    btPoint2PointConstraint joint(swings, btVector3(0, 0, 0));
    scene_.world->addConstraint(&joint);
    EXPECT_NEAR(rock(swings, btVector3(0, 0, -200)), 5, 1e-3) << "a pendulum swings on";
    scene_.world->removeConstraint(&joint);
}

TEST_F(SettledPieces, SleepWhereTheyTurnOnAndOn) {
    const auto turnsFor = [&](btRigidBody& piece, const btVector3& gravity) {
        piece.setGravity(gravity);
        int steps = 0;
        for (; steps < 300 && piece.isActive(); ++steps) {
            piece.applyCentralForce(-gravity / piece.getInvMass());
            piece.setLinearVelocity(btVector3(0, 0, 0));
            piece.setAngularVelocity(btVector3(0, 0, 10));
            scene_.step(1, 1.0 / 60);
        }
        return steps / 60.0;
    };
    EXPECT_EQ(turnsFor(*pieces_[1], btVector3(0, 0, 0)), 5) << "a satellite turns on";
    EXPECT_NEAR(turnsFor(*pieces_[0], btVector3(0, 0, -10)), 4, 0.1);
}

TEST_F(SettledPieces, StayAwakeForAWhileWhereTheyAreDeepInTheGround) {
    const btScalar usual_s = std::exchange(gDeactivationTime, btScalar(0.5));
    const auto sleepsAfter = [&](btRigidBody& piece, btScalar depth_m) {
        btVector3 low, high;
        piece.getAabb(low, high);
        // Between two walls, which push it to and fro, so that it stays as deep in both.
        const btVector3 half(1, btScalar(0.4), 1), middle = (low + high) / 2;
        const btScalar away = (high - low).z() / 2 + half.z() - depth_m;
        for (const btScalar side : {btScalar(-1), btScalar(1)})
            scene_.addBox(0, half, middle + btVector3(0, 0, side * away));
        int steps = 0;
        for (; steps < 300 && piece.isActive(); ++steps) scene_.step(1, 1.0 / 60);
        return steps / 60.0;
    };
    EXPECT_LT(sleepsAfter(*pieces_[0], btScalar(1e-3)), 1.5);
    const double seconds = sleepsAfter(*pieces_[1], btScalar(8e-3));
    EXPECT_GT(seconds, 2);
    EXPECT_LT(seconds, 4) << "what is caught there sleeps in the end";
    btGhostObject zone;  // which pushes nothing
    btBoxShape everywhere(btVector3(50, 50, 50));
    zone.setCollisionShape(&everywhere);
    zone.setCollisionFlags(btCollisionObject::CF_NO_CONTACT_RESPONSE);
    scene_.world->addCollisionObject(&zone);
    EXPECT_LT(sleepsAfter(*pieces_[2], btScalar(1e-3)), 1.5);
    scene_.world->removeCollisionObject(&zone);
    gDeactivationTime = usual_s;
}

TEST_F(SettledPieces, AreMovedOutOfStillGroundAlongAxesThatAreFree) {
    // How far a step of 1/240 s takes a piece up that is 6 mm deep in a box, m.
    const auto rise = [&](btRigidBody& piece, int flags, const btVector3& linear_factor) {
        piece.setGravity(btVector3(0, 0, -10));
        piece.setLinearFactor(linear_factor);
        piece.setLinearVelocity(btVector3(0, 0, 0));
        piece.setAngularVelocity(btVector3(0, 0, 0));
        piece.activate(true);
        btVector3 low, high;
        piece.getAabb(low, high);
        const btVector3 half(btScalar(0.4), btScalar(0.4), 1), middle = (low + high) / 2;
        btRigidBody* ground =
            scene_.addBox(0, half, btVector3(middle.x(), middle.y(), low.z() + btScalar(6e-3) - half.z()));
        ground->setCollisionFlags(ground->getCollisionFlags() | flags);
        scene_.step(1, 1.0 / 240);
        const btScalar before = piece.getCenterOfMassPosition().z();
        scene_.step(1, 1.0 / 240);
        return piece.getCenterOfMassPosition().z() - before;
    };
    const btVector3 free(1, 1, 1), held(1, 1, 0);
    const double by_bullet =
        rise(*pieces_[0], btCollisionObject::CF_KINEMATIC_OBJECT, free);  // the ground may move itself
    const double moved = rise(*pieces_[1], 0, free);
    EXPECT_NEAR(moved - by_bullet, 0.05 / 240, 0.01 / 240);
    EXPECT_EQ(rise(*pieces_[2], 0, held), 0);
}

// The solver does not hold up what is heavier than the piece that it lies on.
TEST(PiecesOfBricks, AreNotPressedIntoTheFloorByThoseThatLieOnThem) {
    const auto brick = BreakableAsset::fromMesh(
        shapes::box(Vec3(-0.125, -0.06, -0.03), Vec3(0.125, 0.06, 0.03)), Material::plaster());
    ASSERT_TRUE(brick.ok()) << brick.error();
    int pieces = 0;
    for (int seed = 8; seed < 14; ++seed) {
        TestWorld scene;
        scene.world->setGravity(btVector3(0, 0, btScalar(-9.81)));
        scene.addBox(0, btVector3(50, 50, 1), btVector3(0, 0, -1));
        FractureWorld fracture(scene.world.get());
        std::mt19937 random(static_cast<unsigned>(seed));
        const auto number = [&] { return btScalar(random() % 2000) * btScalar(1e-3) - 1; };
        BodyOptions options;
        options.seed = static_cast<std::uint64_t>(seed);
        const btScalar x = number(), y = number(), z = number(), w = number();
        options.start = btTransform(btQuaternion(x, y, z, w).normalized(), btVector3(0, 0, btScalar(0.2)));
        options.velocity = btVector3(0, 0, btScalar(-6.4));
        ASSERT_TRUE(fracture.add(brick.value(), options).ok());
        scene.step(3 * 240);
        for (const btRigidBody* body : fracture.bodies()) {
            const btTransform place = fracture.assetTransform(body);
            btScalar lowest = 0;
            for (const Vec3& vertex : fracture.asset(body)->surface().vertices)
                lowest = std::min(lowest, (place * toBullet(vertex)).z());
            EXPECT_GT(lowest, btScalar(-0.004)) << "seed " << seed;
            ++pieces;
        }
    }
    EXPECT_GT(pieces, 30);
}

}  // namespace
