// Pieces on ground that is not static: lifts, crates, tables. They fell through it, or fell asleep inside.

#include <optional>

#include "bullet/support.h"
#include "bullet/world/conversions.h"
#include "core/numerics/mesh_measures.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

enum class Ground { lift, rising_lift, mesh, heaving_mesh, crate, breakable_top };

double lowestOf(const btRigidBody& body, const FractureWorld& fracture) {
    double lowest = 1e9;
    for (const Vec3& vertex : fracture.asset(&body)->surface().vertices)
        lowest = std::min(lowest, fromBullet(fracture.assetTransform(&body) * toBullet(vertex)).z());
    return lowest;
}

class PiecesOn : public testing::TestWithParam<Ground> {
  protected:
    PiecesOn() { scene_.world->setGravity(btVector3(0, 0, -9.81f)); }

    /// Its top is at z = 0.
    btRigidBody* addGround(FractureWorld& fracture) {
        if (GetParam() == Ground::breakable_top) {
            scene_.addBox(0, btVector3(1, 1, 0.5f), btVector3(0, 0, -0.9f));
            const auto slab = BreakableAsset::fromMesh(shapes::box(Vec3(-1, -1, -0.4), Vec3(1, 1, 0)),
                                                       unbreakable(), coarse(0.2));
            return fracture.add(slab.value(), btTransform::getIdentity()).value();
        }
        if (isMesh()) {
            const btVector3 corners[] = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
            if (triangles_.getNumTriangles() == 0) {
                triangles_.addTriangle(corners[0], corners[1], corners[2]);
                triangles_.addTriangle(corners[0], corners[2], corners[3]);
            }
            btRigidBody* mesh = scene_.addBody(std::make_unique<btBvhTriangleMeshShape>(&triangles_, true), 0,
                                               btVector3(0, 0, 0));
            makeKinematic(*mesh);
            return mesh;
        }
        const bool is_crate = GetParam() == Ground::crate;
        if (is_crate) scene_.addBox(0, btVector3(1, 1, 0.5f), btVector3(0, 0, -0.9f));
        btRigidBody* ground =
            scene_.addBox(is_crate ? 100 : 0, btVector3(1, 1, 0.2f), btVector3(0, 0, -0.2f));
        if (!is_crate) makeKinematic(*ground);
        return ground;
    }
    static bool isMesh() { return GetParam() == Ground::mesh || GetParam() == Ground::heaving_mesh; }
    static void makeKinematic(btRigidBody& ground) {
        ground.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
        ground.setActivationState(DISABLE_DEACTIVATION);
    }

    TestWorld scene_;
    btTriangleMesh triangles_;
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
                                                   btVector3(0.3f * btScalar(i - 1), 0, 1.25f)))
                    .ok());
        const int steps = static_cast<int>(4 * rate_hz);
        for (int i = 0; i < steps; ++i) {
            if (GetParam() == Ground::rising_lift && i > steps / 2)
                ground->getWorldTransform().getOrigin().setZ(
                    btScalar(-0.2 + 0.5 * (i - steps / 2) / rate_hz));
            if (GetParam() == Ground::heaving_mesh)
                ground->getWorldTransform().getOrigin().setZ(btScalar(0.3 * std::sin(1.8 * i / rate_hz)));
            scene_.step(1, 1 / rate_hz);
        }
        const double top = ground->getWorldTransform().getOrigin().z() + (isMesh() ? 0 : 0.2);
        int pieces = 0, on_it = 0;
        for (const btRigidBody* body : fracture.bodies()) {
            if (body == ground) continue;
            const btVector3 place = body->getWorldTransform().getOrigin();
            if (std::max(std::abs(place.x()), std::abs(place.y())) > 1) continue;  // rolled off
            ++pieces;
            on_it += lowestOf(*body, fracture) > top - 0.002;
        }
        EXPECT_GT(pieces, 20) << rate_hz;
        EXPECT_EQ(on_it, pieces) << rate_hz;
        if (GetParam() == Ground::breakable_top) fracture.remove(ground);
        for (auto& body : scene_.bodies) scene_.world->removeRigidBody(body.get());
        scene_.bodies.clear();
    }
}

/// A kinematic mesh, and plates that have broken on it.
class PiecesOnAMesh : public testing::Test {
  protected:
    PiecesOnAMesh() {
        scene_.world->setGravity(btVector3(0, 0, -9.81f));
        const btVector3 corners[] = {{-30, -30, 0}, {30, -30, 0}, {30, 30, 0}, {-30, 30, 0}};
        triangles_.addTriangle(corners[0], corners[1], corners[2]);
        triangles_.addTriangle(corners[0], corners[2], corners[3]);
        mesh_ = scene_.addBody(std::make_unique<btBvhTriangleMeshShape>(&triangles_, true), 0,
                               btVector3(0, 0, 0));
        mesh_->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
        mesh_->setActivationState(DISABLE_DEACTIVATION);
        fracture_ = std::make_unique<FractureWorld>(scene_.world.get());
        Settings settings = Settings::forQuality(Quality::preview);
        settings.fracture.fragment_count = 12;
        plate_.emplace(BreakableAsset::fromMesh(shapes::box(Vec3(-0.1, -0.1, -0.004), Vec3(0.1, 0.1, 0.004)),
                                                Material::ceramic(), settings)
                           .value());
    }
    ~PiecesOnAMesh() override { fracture_.reset(); }

    void drop(double height) {
        for (int i = 0; i < 3; ++i)
            ASSERT_TRUE(
                fracture_
                    ->add(*plate_, btTransform(btQuaternion(btVector3(0, 1, 0), btScalar(1 + i)),
                                               btVector3(0.5f * btScalar(i - 1), 0, btScalar(height))))
                    .ok());
    }
    void moveMesh(const btVector3& by) { mesh_->getWorldTransform().getOrigin() += by; }
    int pieces() const { return static_cast<int>(fracture_->bodies().size()); }
    int under() const {
        const auto& bodies = fracture_->bodies();
        return static_cast<int>(std::count_if(bodies.begin(), bodies.end(), [&](const btRigidBody* body) {
            return body->getCenterOfMassPosition().z() < mesh_->getWorldTransform().getOrigin().z();
        }));
    }

    TestWorld scene_;
    btTriangleMesh triangles_;
    btRigidBody* mesh_ = nullptr;
    std::unique_ptr<FractureWorld> fracture_;
    std::optional<BreakableAsset> plate_;
};

TEST_F(PiecesOnAMesh, StayOnItWhenTheAppMovesAllOfTheWorld) {
    drop(1.2);
    scene_.step(120, 1.0 / 60);
    ASSERT_GT(pieces(), 20);
    const btVector3 by(0, 0, -0.03f);
    moveMesh(by);
    for (btRigidBody* body : fracture_->bodies()) body->translate(by);
    scene_.step(30, 1.0 / 60);
    EXPECT_EQ(under(), 0);
}

TEST_F(PiecesOnAMesh, AreNotTakenAlongByOneThatIsSetElsewhere) {
    moveMesh(btVector3(0, 0, 5));
    drop(6.2);
    scene_.step(30, 1.0 / 60);
    moveMesh(btVector3(0, 0, -5));
    scene_.step(120, 1.0 / 60);
    EXPECT_GT(pieces(), 20);
    EXPECT_EQ(under(), 0);
    for (const btRigidBody* body : fracture_->bodies()) EXPECT_LT(body->getCenterOfMassPosition().z(), 0.2);
}

TEST_F(PiecesOnAMesh, AreNotScoopedUpByOneThatIsSetAboveThem) {
    scene_.world->setGravity(btVector3(0, 0, 0));
    drop(1.2);
    scene_.step(2, 1.0 / 60);
    moveMesh(btVector3(0, 0, 3));
    scene_.step(2, 1.0 / 60);
    for (const btRigidBody* body : fracture_->bodies())
        EXPECT_NEAR(body->getCenterOfMassPosition().z(), 1.2, 0.01);
}

TEST_F(PiecesOnAMesh, StayOnOneThatSlidesFast) {
    drop(1.2);
    for (int i = 0; i < 120; ++i) {
        moveMesh(btVector3(0.1f * (i / 10 % 2 ? -1.0f : 1.0f), 0, 0));
        scene_.step(1, 1.0 / 60);
    }
    EXPECT_GT(pieces(), 20);
    EXPECT_EQ(under(), 0);
}

TEST_F(PiecesOnAMesh, StayOnOneThatHeavesFast) {
    drop(1.2);
    for (int i = 0; i < 240; ++i) {
        mesh_->getWorldTransform().getOrigin().setZ(btScalar(0.3 * std::sin(5 * i / 60.0)));
        scene_.step(1, 1.0 / 60);
        ASSERT_EQ(under(), 0) << i;
    }
    EXPECT_GT(pieces(), 20);
}

// Contacts at vertices know nothing of the overlaps that hulls of nested bodies have.
TEST(PiecesInAnotherBody, AreNotPushedOutOfIt) {
    Settings settings = Settings::forQuality(Quality::preview);
    settings.fracture.fragment_count = 12;
    const TriangleMesh mesh = shapes::bowl(0.06, 0.006, 24, 8);
    const auto lower = BreakableAsset::fromMesh(mesh, unbreakable(), settings);
    const auto upper = BreakableAsset::fromMesh(mesh, Material::ceramic(), settings);
    ASSERT_TRUE(lower.ok() && upper.ok());
    for (const double rate_hz : {60.0, 240.0}) {
        TestWorld scene;
        scene.world->setGravity(btVector3(0, 0, -9.81f));
        scene.addFloor();
        FractureWorld fracture(scene.world.get());
        const btScalar height = btScalar(-boundingBox(mesh.vertices).min().z());
        ASSERT_TRUE(fracture.add(lower.value(), at(0, 0, height)).ok());
        btRigidBody* broken = fracture.add(upper.value(), at(0, 0, height + 0.012f)).value();
        scene.step(static_cast<int>(rate_hz / 2), 1 / rate_hz);
        for (btRigidBody* body : fracture.bodies()) body->setGravity(btVector3(0, 0, 0));
        const btVector3 place = broken->getWorldTransform().getOrigin() + btVector3(0.05f, 0, 0.02f);
        ASSERT_TRUE(fracture.applyBlow(broken, {{place, btVector3(-0.3f, 0, -0.1f), 0.005, 3}}).ok());
        ASSERT_GT(fracture.bodies().size(), 5u);
        for (btRigidBody* body : fracture.bodies()) {
            body->setLinearVelocity(btVector3(0, 0, 0));
            body->setAngularVelocity(btVector3(0, 0, 0));
        }
        scene.step(1, 1 / rate_hz);
        double energy_j = 0;
        for (const btRigidBody* body : fracture.bodies())
            energy_j += 0.5 * body->getLinearVelocity().length2() / body->getInvMass();
        EXPECT_LT(energy_j, 5e-5) << rate_hz;  // 5e-4 and 1e-3 if they are
    }
}

/// Bullet keeps the contacts of the step before, which push up, and finds new ones, which push out below.
TEST(WholeBodies, BreakOnALiftThatStartsByMoreThanHalfOfItsHeightInAStep) {
    for (const btScalar speed_m_s : {3, 4, 5, 6, 8}) {
        TestWorld scene;
        scene.world->setGravity(btVector3(0, 0, -9.81f));
        FractureWorld fracture(scene.world.get());
        btRigidBody* lift = scene.addBox(0, btVector3(1, 1, 0.05f), btVector3(0, 0, -0.05f));
        lift->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
        lift->setActivationState(DISABLE_DEACTIVATION);
        const auto dish = BreakableAsset::fromMesh(cylinderMesh(0.13, 0.012, 32), Material::ceramic());
        ASSERT_TRUE(fracture.add(dish.value(), at(0, 0, 0.007f)).ok());
        scene.step(30, 1.0 / 60);
        ASSERT_EQ(fracture.takeEvents().size(), 0u);
        lift->setWorldTransform(at(0, 0, -0.05f + speed_m_s / 60));
        scene.step(1, 1.0 / 60);
        const auto events = fracture.takeEvents();
        ASSERT_EQ(events.size(), 1u) << speed_m_s << " m/s";
        EXPECT_EQ(events[0].outcome, Outcome::broke) << speed_m_s << " m/s";
    }
}

// What is no piece comes out of what supports still hold of a body.
TEST(HeldRests, LiftWhatFallsOntoThem) {
    TestWorld scene;
    scene.world->setGravity(btVector3(0, 0, -9.81f));
    FractureWorld fracture(scene.world.get());
    Settings settings;
    settings.sampling.spacing_m = 0.1;
    settings.fracture.fragment_count = 4;
    const auto slab = BreakableAsset::fromMesh(shapes::box(Vec3(-1, -1, -0.4), Vec3(1, 1, 0), 10, 10, 4),
                                               Material::plaster(), settings);
    const auto held = slab.value().anchored({BoxRegion{{-2, -2, -0.4}, {2, 2, -0.4}}});
    ASSERT_TRUE(held.ok()) << held.error();
    btRigidBody* body = fracture.add(held.value(), btTransform::getIdentity()).value();
    ASSERT_TRUE(
        fracture.applyBlow(body, {{btVector3(0.1f, 0.1f, 0), btVector3(0, 0, -3000), 0.05, 20}}).ok());
    ASSERT_GT(fracture.bodies().size(), 1u);
    std::vector<btRigidBody*> boxes;
    for (int k = 0; k < 8; ++k) {
        boxes.push_back(scene.addBox(0.5, btVector3(0.05f, 0.05f, 0.05f),
                                     btVector3(0.22f * btScalar(k - 3.5), 0.5f, 0.6f)));
        boxes.back()->setLinearVelocity(btVector3(0, 0, -6));
    }
    scene.step(120, 1.0 / 60);
    int on_it = 0;
    for (const btRigidBody* box : boxes) on_it += box->getWorldTransform().getOrigin().z() > 0;
    EXPECT_GE(on_it, 3);  // Bullet loses some; of these none were left
}

INSTANTIATE_TEST_SUITE_P(ThatIsNotStatic, PiecesOn,
                         testing::Values(Ground::lift, Ground::rising_lift, Ground::mesh,
                                         Ground::heaving_mesh, Ground::crate, Ground::breakable_top));

}  // namespace
