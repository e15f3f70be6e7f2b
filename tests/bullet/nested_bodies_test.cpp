// Whole bodies whose hulls overlap though they do not: plates in a stack, and what lies in a bowl.

#include <cmath>

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

constexpr double wall = 0.0045;

/// A plate of 26 cm with a rim that rises by 2 cm.
TriangleMesh dish() {
    constexpr int steps = 14;
    const auto below = [](double part) {
        const double rise = part < 0.55 ? 0 : 0.02 * std::pow((part - 0.55) / 0.45, 1.3);
        return std::pair(0.13 * part, rise);
    };
    std::vector<std::pair<double, double>> profile;
    for (int i = 1; i <= steps; ++i) profile.push_back(below(double(i) / steps));
    for (int i = steps; i >= 1; --i) {
        const auto [radius, height] = below(double(i) / steps);
        profile.emplace_back(radius, height + wall);
    }
    return shapes::revolvedSolid(profile, 48);
}

class NestedBodies : public testing::TestWithParam<double> {
  protected:
    NestedBodies() {
        scene_.world->setGravity(btVector3(0, 0, btScalar(-9.81)));
        scene_.addFloor();
    }
    void step(double seconds) {
        for (int i = 0; i < seconds * GetParam(); ++i) {
            scene_.step(1, 1 / GetParam());
            for (const auto* body : bodies_)
                fastest_ = std::max(fastest_, body->getLinearVelocity().length());
        }
    }
    btRigidBody* add(const BreakableAsset& asset, const btVector3& place) {
        bodies_.push_back(fracture_.add(asset, at(place.x(), place.y(), place.z())).value());
        return bodies_.back();
    }

    TestWorld scene_;
    FractureWorld fracture_{scene_.world.get()};
    std::vector<btRigidBody*> bodies_;
    btScalar fastest_ = 0;
};

BreakableAsset assetOf(const TriangleMesh& mesh) {
    auto asset = BreakableAsset::fromMesh(mesh, Material::ceramic(), Settings::forQuality(Quality::preview));
    EXPECT_TRUE(asset.ok()) << asset.error();
    return std::move(asset).value();
}

/// Their hulls are 16 mm high. Bullet threw them up at 0.7 m/s, and the stack came to rest twice as high.
TEST_P(NestedBodies, PlatesInAStackStayWhereTheyAre) {
    constexpr double apart = wall + 0.001;
    const BreakableAsset plate = assetOf(dish());
    for (int i = 0; i < 8; ++i) add(plate, btVector3(0, 0, btScalar(0.0005 + apart * i)));
    std::vector<btScalar> heights;
    for (const auto* body : bodies_) heights.push_back(body->getCenterOfMassPosition().z());
    step(3);
    EXPECT_TRUE(fracture_.takeEvents().empty());
    EXPECT_LT(fastest_, 9.81 / GetParam() + 0.05) << "what they fall in the first step";
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        EXPECT_NEAR(bodies_[i]->getCenterOfMassPosition().z(), heights[i], 0.002) << i;
}

/// Bullet looks at them when they wake.
TEST_P(NestedBodies, PlatesThatAreAddedAndPutToSleepStayWhereTheyAreWhenTheyWake) {
    const BreakableAsset plate = assetOf(dish());
    for (int i = 0; i < 4; ++i)
        add(plate, btVector3(0, 0, btScalar(0.0005 + (wall + 0.001) * i)))
            ->forceActivationState(ISLAND_SLEEPING);
    scene_.addBall(1, 0.1, btVector3(3, 0, 0.5f));
    step(0.5);
    for (btRigidBody* body : bodies_) body->activate(true);
    step(1);
    EXPECT_TRUE(fracture_.takeEvents().empty());
    EXPECT_LT(fastest_, 9.81 / GetParam() + 0.05);
}

/// On a box of 100 m Bullet's contacts give the lowest plate a spin, and the hulls rub.
TEST_P(NestedBodies, PlatesOnAWideFloorAreNotStruck) {
    scene_.world->removeCollisionObject(scene_.bodies.front().get());
    scene_.addBox(0, btVector3(50, 50, 50), btVector3(0, 0, -50));
    const BreakableAsset plate = assetOf(dish());
    for (int i = 0; i < 8; ++i) add(plate, btVector3(0, 0, btScalar(0.0005 + (wall + 0.001) * i)));
    step(3);
    EXPECT_TRUE(fracture_.takeEvents().empty());
}

/// And the stack is still one of bodies.
TEST_P(NestedBodies, APlateThatIsLiftedOffComesDownAgainOnTheHulls) {
    const BreakableAsset plate = assetOf(dish());
    add(plate, btVector3(0, 0, btScalar(0.0005)));
    btRigidBody* upper = add(plate, btVector3(0, 0, btScalar(0.0005 + wall + 0.001)));
    step(0.2);
    upper->translate(btVector3(0, 0, 0.05f));
    upper->activate(true);
    step(2);
    EXPECT_GT(upper->getCenterOfMassPosition().z(), bodies_[0]->getCenterOfMassPosition().z() + wall);
}

/// A rehearsal of what comes leaves the stack as it is, too.
TEST_P(NestedBodies, ABallThatFliesByMakesNobodyForeseeABlow) {
    const BreakableAsset plate = assetOf(dish());
    ASSERT_TRUE(plate.prepare().ok());
    fracture_.setExecutor([](std::function<void()> job) { job(); });
    for (int i = 0; i < 8; ++i) add(plate, btVector3(0, 0, btScalar(0.0005 + (wall + 0.001) * i)));
    step(1);
    scene_.addBall(2, 0.03, btVector3(0.03f, -1, 0.25f), btVector3(0, 8, 0));
    step(0.25);
    EXPECT_EQ(fracture_.counts().foreseen_in_vain, 0);
    EXPECT_TRUE(fracture_.takeEvents().empty());
}

/// What closes no hollows is in each other in truth.
TEST_P(NestedBodies, SolidBodiesInEachOtherArePushedApart) {
    const BreakableAsset ball = assetOf(shapes::icosphere(0.05, 3));
    btRigidBody *a = add(ball, btVector3(0, 0, 0.5f)), *b = add(ball, btVector3(0.08f, 0, 0.5f));
    step(0.1);
    EXPECT_GT((a->getCenterOfMassPosition() - b->getCenterOfMassPosition()).length(), 0.09);
}

INSTANTIATE_TEST_SUITE_P(StepsASecond, NestedBodies, testing::Values(60.0, 240.0, 480.0));

}  // namespace
