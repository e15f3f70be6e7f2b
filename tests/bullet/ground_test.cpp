// Fragments on ground that is a surface without an inside: triangle meshes and height fields.

#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>

#include <cmath>
#include <optional>
#include <random>

#include "bullet/energy.h"
#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

enum class Surface { two_triangles, hills, height_field };

double heightOfHills(double x, double y) {
    return 0.06 * std::sin(2.1 * x + 0.3) * std::cos(1.7 * y);
}

/// 24 x 24 m about the origin, static.
class Ground {
  public:
    Ground(TestWorld& scene, Surface kind) {
        if (kind == Surface::height_field) {
            for (int j = 0; j <= cells; ++j)
                for (int i = 0; i <= cells; ++i) heights_.push_back(corner(i, j, true).z());
            auto shape = std::make_unique<btHeightfieldTerrainShape>(cells + 1, cells + 1, heights_.data(),
                                                                     btScalar(1), btScalar(-1), btScalar(1),
                                                                     2, PHY_FLOAT, false);
            shape->setLocalScaling(btVector3(cell_m, cell_m, 1));
            body_ = scene.addBody(std::move(shape), 0, btVector3(0, 0, 0));
            return;
        }
        const bool hills = kind == Surface::hills;
        const int step = hills ? 1 : cells;
        for (int j = 0; j < cells; j += step)
            for (int i = 0; i < cells; i += step) {
                triangles_.addTriangle(corner(i, j, hills), corner(i + step, j, hills),
                                       corner(i + step, j + step, hills));
                triangles_.addTriangle(corner(i, j, hills), corner(i + step, j + step, hills),
                                       corner(i, j + step, hills));
            }
        body_ =
            scene.addBody(std::make_unique<btBvhTriangleMeshShape>(&triangles_, true), 0, btVector3(0, 0, 0));
    }
    btRigidBody* body() { return body_; }
    /// Nothing beside it.
    std::optional<double> heightAt(TestWorld& scene, const btVector3& place) const {
        const btVector3 above(place.x(), place.y(), 9), below(place.x(), place.y(), -9);
        btCollisionWorld::AllHitsRayResultCallback ray(above, below);
        scene.world->rayTest(above, below, ray);
        for (int i = 0; i < ray.m_collisionObjects.size(); ++i)
            if (ray.m_collisionObjects[i] == body_) return ray.m_hitPointWorld[i].z();
        return std::nullopt;
    }

  private:
    static constexpr int cells = 160;
    static constexpr btScalar cell_m = btScalar(0.15);
    static btVector3 corner(int i, int j, bool hills) {
        const btScalar x = (i - cells / 2) * cell_m, y = (j - cells / 2) * cell_m;
        return btVector3(x, y, hills ? btScalar(heightOfHills(x, y)) : btScalar(0));
    }
    btTriangleMesh triangles_;
    std::vector<float> heights_;
    btRigidBody* body_ = nullptr;
};

BreakableAsset thinPlate(CollisionShape shape) {
    Settings settings = coarse(0.04);
    settings.fracture.collision_shape = shape;
    settings.fracture.fragment_count = 12;
    const auto asset = BreakableAsset::fromMesh(shapes::slab(Vec3(0.5, 0.5, 0.04)), crumbly(), settings);
    EXPECT_TRUE(asset.ok()) << asset.error();
    return asset.value();
}

/// A plate that falls with 6 m/s, tilted: flat it would go through whole at 60 Hz, as a plain body does.
BodyOptions falling(int drop) {
    BodyOptions options(
        btTransform(btQuaternion(btVector3(1, 0.3f, 0).normalized(), btScalar(0.5 * (drop + 1))),
                    btVector3(0.13f, btScalar(0.21 * drop), 0.6f)));
    options.velocity = btVector3(0.5f, 0, -6);
    options.angular_velocity = btVector3(0, btScalar(drop - 1), 1);
    return options;
}

struct Case {
    Surface ground;
    CollisionShape shape;
    int hz;

    friend void PrintTo(const Case& self, std::ostream* out) { *out << nameOf(self); }
    static std::string nameOf(const Case& self) {
        static constexpr const char* grounds[] = {"two_triangles", "hills", "height_field"};
        static constexpr const char* shape_names[] = {"automatic", "boxes", "hull", "convex_parts"};
        return std::string(grounds[int(self.ground)]) + "_" + shape_names[int(self.shape)] + "_" +
               std::to_string(self.hz);
    }
};

/// Plates that lean in the ground for a while before they break, so many at once that blows wait for their
/// turn.
TEST(GroundCrowd, LosesNoBodyAndNoPieceOfOne) {
    TestWorld scene;
    scene.world->setGravity(btVector3(0, 0, -9.81f));
    const Ground ground(scene, Surface::two_triangles);
    FractureWorld fracture(scene.world.get());
    const auto asset = BreakableAsset::fromMesh(shapes::slab(Vec3(0.5, 0.4, 0.012)), Material::glass(),
                                                Settings::forQuality(Quality::preview));
    ASSERT_TRUE(asset.ok()) << asset.error();
    ASSERT_TRUE(asset.value().prepare().ok());
    std::mt19937 random(7);
    std::uniform_real_distribution<float> any(-1, 1);
    for (int i = 0; i < 25; ++i) {
        const btVector3 axis = btVector3(any(random), any(random), any(random)).normalized();
        const btVector3 place(btScalar(4 * (i % 5 - 2)), btScalar(4 * (i / 5 - 2)),
                              2.6f + 0.3f * any(random));
        BodyOptions options(btTransform(btQuaternion(axis, 3 * any(random)), place));
        ASSERT_TRUE(fracture.add(asset.value(), options).ok());
    }
    scene.step(120, 1.0 / 60);
    EXPECT_GT(fracture.bodies().size(), 100u);
    EXPECT_GT(fracture.counts().waited, 0);
    int lost = 0;
    for (const btRigidBody* body : fracture.bodies()) lost += body->getWorldTransform().getOrigin().z() < 0;
    EXPECT_EQ(lost, 0);
}

// No ray meets a surface that it ends on, nor one that it begins on.
class WallAt : public testing::TestWithParam<btScalar> {};

TEST_P(WallAt, HoldsABodyThatAStepEndsInTheMiddleOf) {
    TestWorld scene;
    btTriangleMesh triangles;
    const btScalar x = GetParam();
    triangles.addTriangle(btVector3(x, -4, -4), btVector3(x, 4, -4), btVector3(x, 4, 4));
    triangles.addTriangle(btVector3(x, -4, -4), btVector3(x, 4, 4), btVector3(x, -4, 4));
    scene.addBody(std::make_unique<btBvhTriangleMeshShape>(&triangles, true), 0, btVector3(0, 0, 0));
    FractureWorld fracture(scene.world.get());
    const auto tile = BreakableAsset::fromMesh(
        shapes::box(Vec3(-0.15, -0.15, -0.003), Vec3(0.15, 0.15, 0.003)), unbreakable(), coarse(0.1));
    BodyOptions options(btTransform(btQuaternion(btVector3(1, 2, 0.5f).normalized(), 0.8f)));
    options.start.setOrigin(btVector3(GetParam() - 2.5f, 0, 0));
    options.velocity = btVector3(30, 0, 0);
    const btRigidBody* body = fracture.add(tile.value(), options).value();
    scene.step(60, 1.0 / 240);  // after 20 steps its centre is at x to the last bit
    EXPECT_LT(body->getCenterOfMassPosition().x(), GetParam());
    fracture.remove(const_cast<btRigidBody*>(body));
}

class Drops : public testing::TestWithParam<Case> {};

TEST_P(Drops, NoFragmentFallsThroughTheGround) {
    const Case drop_case = GetParam();
    const BreakableAsset asset = thinPlate(drop_case.shape);
    int pieces = 0, lost = 0;
    for (int drop = 0; drop < (drop_case.hz > 60 ? 1 : 3); ++drop) {
        TestWorld scene;
        scene.world->setGravity(btVector3(0, 0, -10));
        const Ground ground(scene, drop_case.ground);
        FractureWorld fracture(scene.world.get());
        BodyOptions options = falling(drop);
        options.fracture = asset.settings().fracture;
        options.fracture->rest_after_break_s = 10;
        ASSERT_TRUE(fracture.add(asset, options).ok());
        double most = energyOf(fracture.bodies());
        for (int i = 0; i < 3 * drop_case.hz / 2; ++i) {
            scene.step(1, 1.0 / drop_case.hz);
            const double now = energyOf(fracture.bodies());
            // By what a fragment that is in the ground comes out of it, and rounding.
            EXPECT_LT(now, most + 0.001 * std::abs(most)) << "step " << i;
            most = std::max(most, now);
        }
        EXPECT_GE(fracture.bodies().size(), 4u);
        for (const btRigidBody* piece : fracture.bodies()) {
            ++pieces;
            const btVector3 centre = piece->getCenterOfMassPosition();
            const auto height = ground.heightAt(scene, centre);
            lost += height && centre.z() < *height;
            EXPECT_TRUE(height) << "it has left the ground at " << centre.x() << ", " << centre.y();
        }
    }
    std::printf("%d of %d pieces lost\n", lost, pieces);
    EXPECT_EQ(lost, 0);
}

/// Tilted pieces with their centres just above the ground: about half of each is below, some boxes as a
/// whole.
class Sunk : public testing::TestWithParam<CollisionShape> {
  protected:
    /// `rest_s`: nothing breaks for so long after a break.
    void sinkPieces(double rest_s) {
        BodyOptions options(at(0, 0, 3));
        const BreakableAsset asset = thinPlate(GetParam());
        options.fracture = asset.settings().fracture;
        options.fracture->rest_after_break_s = options.fracture->same_blow_s = rest_s;
        options.fracture->smallest_fragment_m3 = 1e-5;
        btRigidBody* body = fracture_.add(asset, options).value();
        Push push;
        push.point = btVector3(0, 0, 3.02f);
        push.impulse_n_s = btVector3(0, 0, -1);
        push.speed_m_s = 1;
        ASSERT_TRUE(fracture_.applyBlow(body, push).ok());
        pieces_ = fracture_.bodies();
        ASSERT_GE(pieces_.size(), 4u);
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            const btQuaternion tilt(btVector3(btScalar(i % 3), 1, 0).normalized(),
                                    btScalar(0.3 + 0.1 * (i % 4)));
            pieces_[i]->setWorldTransform(btTransform(tilt, btVector3(btScalar(i) - 5, 0.4f, 0.001f)));
            pieces_[i]->setInterpolationWorldTransform(pieces_[i]->getWorldTransform());
            pieces_[i]->setLinearVelocity(btVector3(0, 0, 0));
            pieces_[i]->setAngularVelocity(btVector3(0, 0, 0));
            pieces_[i]->setGravity(btVector3(0, 0, -10));
            pieces_[i]->activate(true);
        }
    }

    TestWorld scene_;
    const Ground ground_{scene_, Surface::two_triangles};
    FractureWorld fracture_{scene_.world.get()};
    std::vector<btRigidBody*> pieces_;
};

// Bullet pushes these down, and half of a hull may go either way. The inner ball comes out in any case.
TEST_P(Sunk, FragmentsComeOutOnTheSideOfTheirCentres) {
    ASSERT_NO_FATAL_FAILURE(sinkPieces(10));
    scene_.step(120, 1.0 / 60);
    for (const btRigidBody* piece : pieces_) {
        EXPECT_GT(piece->getCenterOfMassPosition().z(), 0.007) << "the inner ball has a radius of 0.008";
        EXPECT_LT(piece->getLinearVelocity().length(), 0.5);
    }
}

TEST_P(Sunk, WhatTheyBreakIntoComesOutOnThatSideToo) {
    ASSERT_NO_FATAL_FAILURE(sinkPieces(0));
    for (const btRigidBody* piece : pieces_)  // on the half that is not under the ground
        scene_.addBall(10, 0.05, piece->getCenterOfMassPosition() + btVector3(-0.03f, 0, 0.15f),
                       btVector3(0, 0, -4));
    scene_.step(30, 1.0 / 60);
    int broken = 0;
    for (const BlowEvent& event : fracture_.takeEvents()) broken += event.outcome == Outcome::broke;
    EXPECT_GT(broken, 3);
    scene_.step(90, 1.0 / 60);
    for (const btRigidBody* piece : fracture_.bodies()) EXPECT_GT(piece->getCenterOfMassPosition().z(), 0);
}
TEST_P(Sunk, SoDoesWhatIsBrokenBetweenSteps) {
    ASSERT_NO_FATAL_FAILURE(sinkPieces(0));
    scene_.step(1, 1.0 / 60);
    int broken = 0;
    for (btRigidBody* piece : pieces_) {
        Push push;
        push.point = piece->getCenterOfMassPosition();
        push.impulse_n_s = btVector3(0, 0, -2);
        push.speed_m_s = 4;
        const auto struck = fracture_.applyBlow(piece, push);
        EXPECT_TRUE(struck.ok()) << struck.error();
    }
    for (const BlowEvent& event : fracture_.takeEvents()) broken += event.outcome == Outcome::broke;
    EXPECT_GT(broken, 3);
    scene_.step(120, 1.0 / 60);
    for (const btRigidBody* piece : fracture_.bodies())
        EXPECT_GT(piece->getCenterOfMassPosition().z(), -0.002);
}
INSTANTIATE_TEST_SUITE_P(NearAndFar, WallAt, testing::Values(btScalar(2), btScalar(402)));
INSTANTIATE_TEST_SUITE_P(Ground, Sunk,
                         testing::Values(CollisionShape::automatic, CollisionShape::boxes,
                                         CollisionShape::hull, CollisionShape::convex_parts),
                         [](const auto& info) { return std::string(nameOf(info.param)); });

std::vector<Case> cases() {
    std::vector<Case> all;
    for (const Surface ground : {Surface::two_triangles, Surface::hills, Surface::height_field})
        for (const CollisionShape shape : {CollisionShape::automatic, CollisionShape::boxes,
                                           CollisionShape::hull, CollisionShape::convex_parts})
            for (const int hz : {60, 240}) all.push_back({ground, shape, hz});
    return all;
}
INSTANTIATE_TEST_SUITE_P(Ground, Drops, testing::ValuesIn(cases()),
                         [](const auto& info) { return Case::nameOf(info.param); });

TEST(Ground, OfATrapdoorThatCloses) {
    TestWorld scene;
    FractureWorld fracture(scene.world.get());
    Ground door(scene, Surface::two_triangles);
    btRigidBody* body = fracture.add(plate(crumbly()), at(0, 0, 0.05f)).value();
    scene.step(3);
    scene.world->removeRigidBody(door.body());
    body->setLinearVelocity(btVector3(0, 0, -0.5f));
    scene.step(48);
    body->setLinearVelocity(btVector3(0, 0, 0));
    scene.step(1);
    const btScalar below = body->getCenterOfMassPosition().z();
    ASSERT_LT(below, -0.03f);
    scene.addBall(20, 0.1, btVector3(0.05f, 0.02f, below - 0.131f), btVector3(0, 0, 2));
    scene.world->addRigidBody(door.body());
    ASSERT_EQ(stepUntilBreak(scene, fracture, 5).outcome, Outcome::broke);
    for (const btRigidBody* fragment : fracture.bodies())
        EXPECT_NEAR(fragment->getCenterOfMassPosition().z(), below, 0.02) << "where it was left";
}

/// What a box has after it has fallen into a valley between two slopes of 45 degrees.
struct InAValley {
    InAValley(double size_m, double rate) {
        scene.world->setGravity(btVector3(0, 0, btScalar(-9.81)));
        const btVector3 left[] = {{-3, -3, 3}, {-3, 3, 3}}, middle[] = {{0, -3, 0}, {0, 3, 0}},
                        right[] = {{3, -3, 3}, {3, 3, 3}};
        triangles.addTriangle(left[0], middle[0], left[1]);
        triangles.addTriangle(left[1], middle[0], middle[1]);
        triangles.addTriangle(middle[0], right[0], middle[1]);
        triangles.addTriangle(middle[1], right[0], right[1]);
        scene.addBody(std::make_unique<btBvhTriangleMeshShape>(&triangles, true), 0, btVector3(0, 0, 0));
        const auto asset =
            BreakableAsset::fromMesh(shapes::slab(size_m * Vec3(1, 2, 3)), unbreakable(), coarse(size_m));
        FractureWorld fracture(scene.world.get());
        const btRigidBody* const box = fracture.add(asset.value(), at(0.01f, 0, 0.4f)).value();
        scene.step(static_cast<int>(5 * rate), 1 / rate);
        speed_m_s = box->getLinearVelocity().length();
        height_m = box->getWorldTransform().getOrigin().z();
    }
    TestWorld scene;
    btTriangleMesh triangles;
    double speed_m_s = 0, height_m = 0;
};

TEST(Ground, WhatIsWedgedBetweenTwoSlopesDoesNotGetFasterThere) {
    for (const double rate : {60.0, 120.0, 240.0})
        for (const double size_m : {0.01, 0.03}) {
            const InAValley box(size_m, rate);
            EXPECT_LT(box.speed_m_s, 0.5) << rate << " Hz, " << size_m;
            EXPECT_GT(box.height_m, 0) << rate << " Hz, " << size_m;
        }
}

}  // namespace
