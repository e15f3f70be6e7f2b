// Balls with continuous collision go through what they break.

#include <algorithm>
#include <cmath>
#include <ostream>
#include <vector>

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

constexpr auto broke = Outcome::broke;
/// What is shot.
struct Ball {
    double mass_kg, radius_m;
    bool is_cube = false;  ///< with edges of twice the radius
    double tilt = 0;       ///< of the cube, rad
};
constexpr Ball light{2, 0.05};
constexpr Ball steel{33, 0.1};

/// An open box with walls of 1 cm, 8 x 8 x 9 cm.
TriangleMesh cup() {
    const std::vector<double> sides = {-0.04, -0.03, 0.03, 0.04}, heights = {-0.045, -0.035, 0.045};
    return shapes::rectilinear(sides, sides, heights,
                               [](int i, int j, int k) { return i != 1 || j != 1 || k == 0; });
}

enum class Target { pane, wall, cups };

/// The wall of 37 kg all but stops the light ball: when that comes out of the rubble differs by more than a
/// step of 60 Hz between 480, 960 and 1920 Hz, so that there is nothing to compare with.
Ball ballFor(Target target) {
    return target == Target::wall ? steel : light;
}

struct Shot {
    Target target;
    double speed_m_s;
    CollisionShape shape = CollisionShape::boxes;

    friend void PrintTo(const Shot& self, std::ostream* out) { *out << nameOf(self); }
    static std::string nameOf(const Shot& self) {
        static constexpr const char* targets[] = {"pane", "wall", "cups"};
        static constexpr const char* shape_names[] = {"automatic", "boxes", "hull", "convex_parts"};
        return std::string(targets[static_cast<int>(self.target)]) + "_" +
               std::to_string(static_cast<int>(self.speed_m_s)) + "_" +
               shape_names[static_cast<int>(self.shape)];
    }
};

struct Passage {
    int breaks = 0;
    /// Relative difference between the way of a step and velocity times step. Bullet's own sweep takes a
    /// whole body that is pushed ahead for one that stands, and stops the ball there: such steps do not
    /// count.
    double worst_way = 0;
    double time_s = -1;  // from the start until the ball has passed all
    double last_speed_m_s = 0, last_spin_rad_s = 0;
    btScalar threshold = 0, swept_radius = 0;  // the ball's, in the end
};

class ShootingRange {
  public:
    ShootingRange(const Shot& shot, const Ball& ball, double swept_share = 0.8) {
        Settings settings = coarse(shot.target == Target::cups ? 0.02 : 0.05);
        settings.fracture.collision_shape = shot.shape;
        settings.fracture.smallest_fragment_m3 = 0;
        const TriangleMesh mesh = shot.target == Target::pane   ? shapes::slab(Vec3(0.02, 0.6, 0.6))
                                  : shot.target == Target::wall ? shapes::slab(Vec3(0.09, 0.6, 0.6))
                                                                : cup();
        const auto asset = BreakableAsset::fromMesh(mesh, crumbly(), settings);
        EXPECT_TRUE(asset.ok()) << asset.error();
        const int count = shot.target == Target::cups ? 5 : 1;
        for (int i = 0; i < count; ++i) {
            const auto whole = fracture_.add(asset.value(), at(btScalar(0.12) * i, 0, 0));
            EXPECT_TRUE(whole.ok()) << whole.error();
            wholes_.push_back(whole.value());
        }
        end_m_ = 0.12 * (count - 1) + 0.05 + 2 * ball.radius_m;
        const btVector3 start(btScalar(-0.26 - ball.radius_m), 0.011f, 0.007f);
        const auto half = btScalar(ball.radius_m);
        ball_ = ball.is_cube ? scene_.addBox(ball.mass_kg, btVector3(half, half, half), start)
                             : scene_.addBall(ball.mass_kg, ball.radius_m, start);
        ball_->setLinearVelocity(btVector3(btScalar(shot.speed_m_s), 0, 0));
        if (ball.is_cube)
            ball_->setCenterOfMassTransform(
                btTransform(btQuaternion(btVector3(0, 1, 0.3f).normalized(), btScalar(ball.tilt)), start));
        ball_->setCcdMotionThreshold(0.02f);
        ball_->setCcdSweptSphereRadius(btScalar(swept_share * ball.radius_m));
    }

    Passage shoot(double hz) {
        Passage passage;
        const double dt = 1 / hz;
        for (int i = 0; i < 3 * hz && passage.time_s < 0; ++i) {
            const btVector3 from = ball_->getCenterOfMassPosition();
            scene_.step(1, dt);
            const btVector3 to = ball_->getCenterOfMassPosition();
            for (const BlowEvent& event : fracture_.takeEvents()) passage.breaks += event.outcome == broke;
            const double expected = ball_->getLinearVelocity().length() * dt;
            if (passage.breaks > 0 && !isWholePushed())
                passage.worst_way =
                    std::max(passage.worst_way, std::abs((to - from).length() / expected - 1));
            if (to.x() > end_m_)
                passage.time_s = (i + 1 - (to.x() - end_m_) / std::max<double>(to.x() - from.x(), 1e-9)) * dt;
        }
        passage.last_speed_m_s = ball_->getLinearVelocity().x();
        passage.last_spin_rad_s = ball_->getAngularVelocity().length();
        passage.threshold = ball_->getCcdMotionThreshold();
        passage.swept_radius = ball_->getCcdSweptSphereRadius();
        return passage;
    }

  private:
    bool isWholePushed() const {
        return std::any_of(wholes_.begin(), wholes_.end(), [&](const btRigidBody* whole) {
            const auto& bodies = fracture_.bodies();
            return std::find(bodies.begin(), bodies.end(), whole) != bodies.end() &&
                   whole->getLinearVelocity().x() > 1;
        });
    }

    TestWorld scene_;
    FractureWorld fracture_{scene_.world.get()};
    std::vector<const btRigidBody*> wholes_;
    btRigidBody* ball_ = nullptr;
    double end_m_ = 0;
};

class Shots : public testing::TestWithParam<Shot> {};

TEST_P(Shots, BallGoesThroughWhatItBreaks) {
    const Ball ball = ballFor(GetParam().target);
    const Passage coarse = ShootingRange(GetParam(), ball).shoot(60);
    const Passage fine = ShootingRange(GetParam(), ball).shoot(480);
    std::printf("way %.3f, passed after %.4f s (%.4f s at 480 Hz), speed %.2f (%.2f), breaks %d (%d)\n",
                coarse.worst_way, coarse.time_s, fine.time_s, coarse.last_speed_m_s, fine.last_speed_m_s,
                coarse.breaks, fine.breaks);
    EXPECT_GT(coarse.breaks, 0);
    EXPECT_LT(coarse.worst_way, 0.1);
    ASSERT_GT(coarse.time_s, 0) << "it never came through";
    EXPECT_NEAR(coarse.time_s, fine.time_s, 1.0 / 60);
    EXPECT_EQ(coarse.threshold, 0.02f);
    EXPECT_EQ(coarse.swept_radius, btScalar(0.8 * ball.radius_m));
}

TEST(ContinuousCollision, LightBallMovesAsFastAsItsVelocitySaysInAHeavyWall) {
    for (const double speed : {5., 12., 20., 40.}) {
        const Passage passage = ShootingRange({Target::wall, speed}, light).shoot(60);
        EXPECT_GT(passage.breaks, 0) << speed;
        EXPECT_LT(passage.worst_way, 0.1) << speed;
        EXPECT_GT(passage.time_s, 0) << speed << ": it never came through";
    }
}

TEST(ContinuousCollision, BallIsSlowedByAllThatIsInItsWayWhateverSphereItSweeps) {
    for (const CollisionShape shape : {CollisionShape::boxes, CollisionShape::convex_parts})
        for (const double speed : {5., 12.}) {
            const Shot shot{Target::pane, speed, shape};
            const double fine = ShootingRange(shot, light).shoot(480).last_speed_m_s;
            for (const double share : {0.2, 0.5, 0.8}) {
                const double left = ShootingRange(shot, light, share).shoot(60).last_speed_m_s;
                EXPECT_NEAR(left, fine, 0.15 * fine) << Shot::nameOf(shot) << ", " << share;
            }
        }
}

TEST(ContinuousCollision, CubeIsSlowedAndTurnedAboutAsInShortSteps) {
    double off = 0, spin = 0, fine_spin = 0;
    int count = 0;
    for (const double speed : {6., 12., 20.})
        for (const double tilt : {0., 0.2, 0.5, 0.7}) {
            const Ball cube{2, 0.05, true, tilt};
            const Shot shot{Target::pane, speed};
            const Passage fine = ShootingRange(shot, cube, 0.5).shoot(480);
            const Passage coarse = ShootingRange(shot, cube, 0.5).shoot(60);
            off += std::abs(coarse.last_speed_m_s / fine.last_speed_m_s - 1);
            spin += coarse.last_spin_rad_s;
            fine_spin += fine.last_spin_rad_s;
            ++count;
        }
    EXPECT_LT(off / count, 0.12);
    EXPECT_LT(spin, 1.2 * fine_spin) << "one point of its own shape turns it";
}

std::vector<Shot> shots() {
    std::vector<Shot> all;
    for (const Target target : {Target::pane, Target::wall, Target::cups})
        for (const double speed : {5., 12., 20., 40.}) all.push_back({target, speed});
    for (const CollisionShape shape : {CollisionShape::hull, CollisionShape::convex_parts})
        for (const Target target : {Target::pane, Target::cups}) all.push_back({target, 12, shape});
    return all;
}
INSTANTIATE_TEST_SUITE_P(ContinuousCollision, Shots, testing::ValuesIn(shots()),
                         [](const auto& info) { return Shot::nameOf(info.param); });

}  // namespace
