// Fragments on flat ground, in steps that are long for their size.

#include <algorithm>
#include <set>

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

/// The pieces of a plate, each by itself over a floor: they fall on it, turned in many ways.
class FlatGround : public testing::Test {
  protected:
    void dropPieces(std::unique_ptr<btCollisionShape> ground, btScalar top) {
        scene_.world->setGravity(btVector3(0, 0, -9.81f));
        ground_ = scene_.addBody(std::move(ground), 0, btVector3(0, 0, -top));
        fracture_ = std::make_unique<FractureWorld>(scene_.world.get());
        Settings settings = Settings::forQuality(Quality::preview);
        settings.fracture.fragment_count = 20;
        settings.fracture.rest_after_break_s = 1e3;
        const auto asset = BreakableAsset::fromMesh(shapes::slab(Vec3(0.3, 0.3, 0.012), 8, 8, 1),
                                                    Material::ceramic(), settings);
        ASSERT_TRUE(asset.ok()) << asset.error();
        BodyOptions options;
        options.start.setOrigin(btVector3(0, 0, 3));
        btRigidBody* body = fracture_->add(asset.value(), options).value();
        Push push;
        push.point = btVector3(0.01f, 0.02f, 3.006f);
        push.impulse_n_s = btVector3(0, 0, -20);
        push.speed_m_s = 5;
        ASSERT_TRUE(fracture_->applyBlow(body, push).ok());
        pieces_ = fracture_->bodies();
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            const btQuaternion turn(btVector3(1, btScalar(i % 3), 0.3f).normalized(),
                                    btScalar(0.7) * btScalar(i));
            pieces_[i]->setCenterOfMassTransform(btTransform(turn, btVector3(0, btScalar(i) - 10, 1)));
            pieces_[i]->setLinearVelocity(btVector3(0, 0, -2));
            pieces_[i]->setAngularVelocity(btVector3(0, 0, 0));
        }
        ASSERT_GE(pieces_.size(), 8u);
    }

    int awake() const {
        return static_cast<int>(std::count_if(pieces_.begin(), pieces_.end(),
                                              [](const btRigidBody* piece) { return piece->isActive(); }));
    }

    /// Below z = 0, m.
    double deepest() const {
        double lowest = 0;
        for (const btRigidBody* piece : pieces_)
            for (const Vec3& v : fracture_->asset(piece)->surface().vertices) {
                const btVector3 place(btScalar(v.x()), btScalar(v.y()), btScalar(v.z()));
                lowest = std::min(lowest, double((fracture_->assetTransform(piece) * place).z()));
            }
        return -lowest;
    }

    void expectRest() {
        scene_.step(5 * 60, 1.0 / 60);
        EXPECT_EQ(awake(), 0) << "of " << pieces_.size();
        EXPECT_LT(deepest(), 1e-3);
    }

    TestWorld scene_;
    std::unique_ptr<FractureWorld> fracture_;
    btRigidBody* ground_ = nullptr;
    std::vector<btRigidBody*> pieces_;
};

TEST_F(FlatGround, OfALargeBoxLetsSplintersRest) {
    dropPieces(std::make_unique<btBoxShape>(btVector3(200, 200, 1)), 1);
    expectRest();
}

TEST_F(FlatGround, OfASmallBoxLetsSplintersRest) {
    dropPieces(std::make_unique<btBoxShape>(btVector3(12, 12, 0.5f)), 0.5f);
    expectRest();
}

TEST_F(FlatGround, OfAPlaneLetsSplintersRest) {
    dropPieces(std::make_unique<btStaticPlaneShape>(btVector3(0, 0, 1), btScalar(0)), 0);
    expectRest();
}

TEST_F(FlatGround, HasItsContactsOnItsFace) {
    dropPieces(std::make_unique<btBoxShape>(btVector3(200, 200, 1)), 1);
    int counted = 0;
    for (int step = 0; step < 120; ++step) {
        scene_.step(1, 1.0 / 60);
        btDispatcher& dispatcher = *scene_.dispatcher;
        for (int m = 0; m < dispatcher.getNumManifolds(); ++m) {
            const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(m);
            const bool is_a = manifold.getBody1() == ground_;
            if (!is_a && manifold.getBody0() != ground_) continue;
            for (int p = 0; p < manifold.getNumContacts(); ++p) {
                const btManifoldPoint& point = manifold.getContactPoint(p);
                if (point.getAppliedImpulse() == 0) continue;
                ++counted;
                const btVector3 up = is_a ? point.m_normalWorldOnB : -point.m_normalWorldOnB;
                EXPECT_GT(up.z(), 1 - 1e-6f);
                const btVector3& below = is_a ? point.m_positionWorldOnB : point.m_positionWorldOnA;
                EXPECT_NEAR(below.z(), 0, 1e-5);
            }
        }
    }
    EXPECT_GT(counted, 100);
}

/// Manifolds that Bullet has told the app of.
struct Touching {
    Touching() {
        manifolds.clear();
        started = unknown_ends = 0;
        gContactStartedCallback = [](btPersistentManifold* const& manifold) {
            ++started;
            manifolds.insert(manifold);
        };
        gContactEndedCallback = [](btPersistentManifold* const& manifold) {
            unknown_ends += manifolds.erase(manifold) == 0;
        };
    }
    ~Touching() {
        gContactStartedCallback = nullptr;
        gContactEndedCallback = nullptr;
    }
    inline static std::set<const btPersistentManifold*> manifolds;
    inline static int started = 0, unknown_ends = 0;
};

TEST_F(FlatGround, EndsNoContactThatNeverBegan) {
    const Touching touching;
    dropPieces(std::make_unique<btBoxShape>(btVector3(200, 200, 1)), 1);
    scene_.step(180, 1.0 / 60);
    EXPECT_GE(touching.started, static_cast<int>(pieces_.size()));
    EXPECT_EQ(touching.unknown_ends, 0);
}

}  // namespace
