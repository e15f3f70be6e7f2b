// Fragments on even ground, in steps that are long for their size.

#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "bullet/support.h"
#include "core/numerics/mesh_measures.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

/// The pieces of a plate, each by itself over a floor: they fall on it, turned in many ways.
class StandingContacts : public testing::Test {
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

    /// Before what its ground is made of goes.
    void removeAll() {
        pieces_.clear();
        fracture_.reset();
        scene_.world->removeRigidBody(ground_);
    }

    TestWorld scene_;
    std::unique_ptr<FractureWorld> fracture_;
    btRigidBody* ground_ = nullptr;
    std::vector<btRigidBody*> pieces_;
};

TEST_F(StandingContacts, OnALargeBoxLetSplintersRest) {
    dropPieces(std::make_unique<btBoxShape>(btVector3(200, 200, 1)), 1);
    expectRest();
}

TEST_F(StandingContacts, OnASmallBoxLetSplintersRest) {
    dropPieces(std::make_unique<btBoxShape>(btVector3(12, 12, 0.5f)), 0.5f);
    expectRest();
}

TEST_F(StandingContacts, OnAPlaneLetSplintersRest) {
    dropPieces(std::make_unique<btStaticPlaneShape>(btVector3(0, 0, 1), btScalar(0)), 0);
    expectRest();
}

/// Pieces that are in the ground.
class DeepInGround : public StandingContacts {
  protected:
    void expectOut(std::unique_ptr<btCollisionShape> ground, btScalar top) {
        dropPieces(std::move(ground), top);
        for (btRigidBody* piece : pieces_) {
            btTransform deep = piece->getCenterOfMassTransform();
            deep.getOrigin().setZ(-0.2f);
            piece->setCenterOfMassTransform(deep);
            piece->setLinearVelocity(btVector3(0, 0, 0));
        }
        expectAbove(-0.005f);
    }
    void expectNoneLost(std::unique_ptr<btCollisionShape> ground, btScalar top) {
        dropPieces(std::move(ground), top);
        for (btRigidBody* piece : pieces_) piece->setLinearVelocity(btVector3(0, 0, -4));
        expectAbove(-0.5f);
    }

  private:
    void expectAbove(btScalar lowest) {
        scene_.step(6 * 60, 1.0 / 60);
        for (const btRigidBody* piece : pieces_) EXPECT_GT(piece->getCenterOfMassPosition().z(), lowest);
        removeAll();
    }
};

TEST_F(DeepInGround, PiecesComeOutOfABox) {
    expectOut(std::make_unique<btBoxShape>(btVector3(12, 12, 0.5f)), 0.5f);
}

TEST_F(DeepInGround, PiecesComeOutOfAPlane) {
    expectOut(std::make_unique<btStaticPlaneShape>(btVector3(0, 0, 1), btScalar(0)), 0);
}

// Out of a hull of 24 m Bullet takes them no better.
TEST_F(DeepInGround, PiecesAreNotLostInAHull) {
    auto hull = std::make_unique<btConvexHullShape>();
    for (const btScalar x : {-12.f, 12.f})
        for (const btScalar y : {-12.f, 12.f})
            for (const btScalar z : {-0.5f, 0.5f}) hull->addPoint(btVector3(x, y, z), false);
    hull->recalcLocalAabb();
    const btScalar top = 0.5f + hull->getMargin();
    expectNoneLost(std::move(hull), top);
}

TEST_F(DeepInGround, PiecesAreNotLostInACylinder) {
    expectNoneLost(std::make_unique<btCylinderShapeZ>(btVector3(15, 15, 0.5f)), 0.5f);
}

/// Triangles over a square around the origin, z = bump * sin(3 x) cos(2 y).
class Terrain {
  public:
    explicit Terrain(int count, btScalar bump = 0) {
        const auto at = [&](int i, int j) {
            const btScalar x = half * btScalar(2 * i - count) / btScalar(count),
                           y = half * btScalar(2 * j - count) / btScalar(count);
            return btVector3(x, y, bump * std::sin(3 * x) * std::cos(2 * y));
        };
        for (int i = 0; i < count; ++i)
            for (int j = 0; j < count; ++j) {
                triangles_.addTriangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
                triangles_.addTriangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
            }
    }
    std::unique_ptr<btCollisionShape> shape() {
        return std::make_unique<btBvhTriangleMeshShape>(&triangles_, true);
    }
    static constexpr btScalar half = 13;

  private:
    btTriangleMesh triangles_;
};

TEST_F(StandingContacts, OnATriangleMeshLetSplintersRest) {
    Terrain coarse(4), fine(520);
    for (Terrain* terrain : {&coarse, &fine}) {
        dropPieces(terrain->shape(), 0);
        expectRest();
        removeAll();
    }
}

TEST_F(StandingContacts, OnATriangleMeshInACompoundLetSplintersRest) {
    Terrain terrain(40);
    const auto mesh = terrain.shape();
    auto compound = std::make_unique<btCompoundShape>();
    compound->addChildShape(btTransform(btQuaternion(btVector3(0, 0, 1), 1), btVector3(0, 0, 0.5f)),
                            mesh.get());
    dropPieces(std::move(compound), 0.5f);
    expectRest();
    removeAll();
}

/// The pieces fall close to the wall, and some against it.
TEST_F(StandingContacts, OnABoxBesideAMeshLetSplintersRest) {
    btTriangleMesh triangles;
    const btVector3 low(-0.1f, -13, 0), high(-0.1f, 13, 0), up(0, 0, 1);
    triangles.addTriangle(low, high, high + up);
    triangles.addTriangle(low, high + up, low + up);
    btBvhTriangleMeshShape wall(&triangles, true);
    btBoxShape box(btVector3(13, 13, 1));
    auto compound = std::make_unique<btCompoundShape>();
    compound->addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, -1)), &box);
    compound->addChildShape(btTransform::getIdentity(), &wall);
    dropPieces(std::move(compound), 0);
    scene_.step(8 * 60, 1.0 / 60);
    EXPECT_EQ(awake(), 0) << "of " << pieces_.size();
    EXPECT_LT(deepest(), 1e-3);
    removeAll();
}

/// A plate on a roof that is almost flat, its ridge below the middle: no vertex is over the ridge.
TEST_F(StandingContacts, OnARidgeLeaveItToBullet) {
    btTriangleMesh triangles;
    for (const btScalar side : {-1.f, 1.f}) {
        const btVector3 foot(10 * side, 0, -0.6f), along(0, 10, 0);
        triangles.addTriangle(-along, along, foot + along);
        triangles.addTriangle(-along, foot + along, foot - along);
    }
    dropPieces(std::make_unique<btBvhTriangleMeshShape>(&triangles, true), 0);
    btRigidBody* const piece = *std::min_element(
        pieces_.begin(), pieces_.end(), [](auto* a, auto* b) { return a->getInvMass() < b->getInvMass(); });
    const Vec3 size = boundingBox(fracture_->asset(piece)->surface()).sizes();
    ASSERT_GT(size.minCoeff(), 0.01);
    for (btRigidBody* other : pieces_)
        if (other != piece) scene_.world->removeRigidBody(other);
    const btTransform body_from_asset =
        piece->getWorldTransform().inverse() * fracture_->assetTransform(piece);
    const Vec3 centre = boundingBox(fracture_->asset(piece)->surface()).center();
    piece->setCenterOfMassTransform(
        btTransform(btQuaternion::getIdentity(),
                    btVector3(-btScalar(centre.x()), 0, btScalar(size.z() / 2 - centre.z()) + 0.002f)) *
        body_from_asset.inverse());
    piece->setLinearVelocity(btVector3(0, 0, 0));
    scene_.step(60, 1.0 / 60);
    const Vec3 lower(centre.x(), centre.y(), centre.z() - size.z() / 2);
    const btVector3 middle = fracture_->assetTransform(piece) *
                             btVector3(btScalar(lower.x()), btScalar(lower.y()), btScalar(lower.z()));
    EXPECT_LT(std::abs(middle.x()), 0.02);
    EXPECT_GT(middle.z() + 0.06f * std::abs(middle.x()), -1e-3);
    removeAll();
}

TEST_F(StandingContacts, OnGentleHillsLetSplintersRest) {
    Terrain terrain(60, 0.05f);
    dropPieces(terrain.shape(), 0);
    scene_.step(8 * 60, 1.0 / 60);
    EXPECT_EQ(awake(), 0) << "of " << pieces_.size();
    removeAll();
}

TEST_F(StandingContacts, OnAHeightFieldLetSplintersRest) {
    const std::vector<float> heights(41 * 41, 0.f);
    auto field = std::make_unique<btHeightfieldTerrainShape>(41, 41, heights.data(), btScalar(1), -1, 1, 2,
                                                             PHY_FLOAT, false);
    dropPieces(std::move(field), 0);
    expectRest();
    removeAll();
}

/// The pieces are thrown up from a box against a mesh.
TEST_F(StandingContacts, UnderACeilingDoNotPullThroughIt) {
    Terrain terrain(40);
    dropPieces(std::make_unique<btBoxShape>(btVector3(200, 200, 1)), 1);
    scene_.addBody(terrain.shape(), 0, btVector3(0, 0, 0.5f));
    for (btRigidBody* piece : pieces_) {
        btTransform place = piece->getWorldTransform();
        place.getOrigin().setZ(0.25f);
        piece->setCenterOfMassTransform(place);
        piece->setLinearVelocity(btVector3(0, 0, 4));
    }
    scene_.step(3 * 60, 1.0 / 60);
    for (const btRigidBody* piece : pieces_) {
        EXPECT_LT(piece->getWorldTransform().getOrigin().z(), 0.1f);
        EXPECT_GT(piece->getWorldTransform().getOrigin().z(), 0);
    }
    removeAll();
}

/// How far a place is from the nearest vertex of a shape, as its margin moves it along `down`, m.
btScalar distanceFromVertices(const btCollisionShape& shape, const btTransform& frame, const btVector3& place,
                              const btVector3& down) {
    btScalar least = BT_LARGE_FLOAT;
    if (shape.isCompound()) {
        const auto& compound = static_cast<const btCompoundShape&>(shape);
        for (int i = 0; i < compound.getNumChildShapes(); ++i)
            least = std::min(least, distanceFromVertices(*compound.getChildShape(i),
                                                         frame * compound.getChildTransform(i), place, down));
        return least;
    }
    const auto& hull = static_cast<const btConvexHullShape&>(shape);
    for (int i = 0; i < hull.getNumPoints(); ++i)
        least = std::min(least, (frame * hull.getScaledPoint(i) + hull.getMargin() * down - place).length());
    return least;
}

TEST_F(StandingContacts, AreAtVertices) {
    Terrain terrain(40);
    dropPieces(terrain.shape(), 0);
    int counted = 0, elsewhere = 0;
    for (int step = 0; step < 120; ++step) {
        std::vector<btTransform> stood;
        for (const btRigidBody* piece : pieces_) stood.push_back(piece->getWorldTransform());
        scene_.step(1, 1.0 / 60);
        for (int m = 0; m < scene_.dispatcher->getNumManifolds(); ++m) {
            const btPersistentManifold& manifold = *scene_.dispatcher->getManifoldByIndexInternal(m);
            const bool is_a = manifold.getBody1() == ground_;
            if (!is_a && manifold.getBody0() != ground_) continue;
            const auto piece =
                std::find(pieces_.begin(), pieces_.end(), is_a ? manifold.getBody0() : manifold.getBody1());
            if (piece == pieces_.end()) continue;
            for (int p = 0; p < manifold.getNumContacts(); ++p) {
                const btManifoldPoint& point = manifold.getContactPoint(p);
                const btVector3& place = is_a ? point.m_positionWorldOnA : point.m_positionWorldOnB;
                const btVector3 down = is_a ? -point.m_normalWorldOnB : point.m_normalWorldOnB;
                ++counted;
                elsewhere +=
                    distanceFromVertices(*(*piece)->getCollisionShape(),
                                         stood[std::size_t(piece - pieces_.begin())], place, down) > 1e-5f;
            }
        }
    }
    EXPECT_GT(counted, 300);
    EXPECT_EQ(elsewhere, 0);
    removeAll();
}

TEST_F(StandingContacts, AreOnTheFaceOfABox) {
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

TEST_F(StandingContacts, EndOnlyIfTheyBegan) {
    const Touching touching;
    dropPieces(std::make_unique<btBoxShape>(btVector3(200, 200, 1)), 1);
    scene_.step(180, 1.0 / 60);
    EXPECT_GE(touching.started, static_cast<int>(pieces_.size()));
    EXPECT_EQ(touching.unknown_ends, 0);
}

}  // namespace
