// Two runs of one program give the same bits of every body at every step, wherever the memory comes from.

#include <cstdlib>
#include <random>

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

constexpr int step_count = 60;

/// Leaves holes of the size of Bullet's contacts all over the heap, other ones for every seed: contacts
/// beyond the pool then get their places in another order.
class HeapNoise {
  public:
    explicit HeapNoise(unsigned seed) {
        std::mt19937 random(seed);
        for (int i = 0; i < 2000; ++i) blocks_.push_back(std::malloc(size));
        std::shuffle(blocks_.begin(), blocks_.end(), random);
        for (std::size_t i = 0; i < blocks_.size() / 2; ++i) {
            std::free(blocks_.back());
            blocks_.pop_back();
        }
    }
    ~HeapNoise() {
        for (void* block : blocks_) std::free(block);
    }

  private:
    static constexpr std::size_t size = sizeof(btPersistentManifold) + 16;
    std::vector<void*> blocks_;
};

struct Record {
    std::vector<btScalar> numbers;
    int breaks = 0, most_contacts = 0;
};

/// A plate on many small legs, with many small balls on it, is struck by a ball.
Record run(CollisionShape shape, int contacts_in_pool, unsigned noise_seed) {
    TestWorld scene;
    scene.world.reset();
    btDefaultCollisionConstructionInfo info;
    info.m_defaultMaxPersistentManifoldPoolSize = contacts_in_pool;
    scene.configuration = std::make_unique<btDefaultCollisionConfiguration>(info);
    scene.dispatcher = std::make_unique<btCollisionDispatcher>(scene.configuration.get());
    scene.world = std::make_unique<btDiscreteDynamicsWorld>(scene.dispatcher.get(), scene.broadphase.get(),
                                                            scene.solver.get(), scene.configuration.get());
    scene.world->setGravity(btVector3(0, 0, -9.81f));
    FractureWorld fracture(scene.world.get());
    Settings settings = coarse(0.06);
    settings.fracture.collision_shape = shape;
    const auto asset = BreakableAsset::fromMesh(shapes::box(Vec3(-0.3, -0.3, -0.03), Vec3(0.3, 0.3, 0.03)),
                                                Material::plaster(), settings);
    EXPECT_TRUE(fracture.add(asset.value(), at(0, 0, 0)).ok());
    for (int i = -2; i <= 2; ++i)
        for (int j = -2; j <= 2; ++j) {
            scene.addBox(0, btVector3(0.02f, 0.02f, 0.02f), btVector3(0.12f * i, 0.12f * j, -0.051f));
            scene.addBall(0.05, 0.04, btVector3(0.12f * i, 0.12f * j, 0.071f));
        }
    scene.addBall(5, 0.06, btVector3(0.06f, 0.06f, 1), btVector3(0, 0, -8));

    const HeapNoise noise(noise_seed);
    Record result;
    for (int i = 0; i < step_count; ++i) {
        scene.step();
        result.most_contacts = std::max(result.most_contacts, scene.dispatcher->getNumManifolds());
        const auto& objects = scene.world->getCollisionObjectArray();
        for (int k = 0; k < objects.size(); ++k) {
            btScalar matrix[16];
            objects[k]->getWorldTransform().getOpenGLMatrix(matrix);
            result.numbers.insert(result.numbers.end(), matrix, matrix + 16);
            const btRigidBody* body = btRigidBody::upcast(objects[k]);
            for (int axis = 0; axis < 3; ++axis) {
                result.numbers.push_back(body->getLinearVelocity()[axis]);
                result.numbers.push_back(body->getAngularVelocity()[axis]);
            }
        }
    }
    for (const BlowEvent& event : fracture.takeEvents()) result.breaks += event.outcome == Outcome::broke;
    return result;
}

class Reproducibility : public testing::TestWithParam<CollisionShape> {};

TEST_P(Reproducibility, SameBitsWhereverContactsGetTheirMemory) {
    const Record in_pool = run(GetParam(), 4096, 0);
    EXPECT_GT(in_pool.breaks, 0);
    for (const unsigned seed : {1u, 2u, 3u}) {
        const Record beyond = run(GetParam(), 1, seed);
        EXPECT_GT(beyond.most_contacts, 60) << "nothing was tested";
        ASSERT_EQ(beyond.numbers.size(), in_pool.numbers.size());
        for (std::size_t i = 0; i < in_pool.numbers.size(); ++i)
            ASSERT_EQ(beyond.numbers[i], in_pool.numbers[i]) << "number " << i << " of run " << seed;
    }
}

std::string nameOf(const testing::TestParamInfo<CollisionShape>& info) {
    static constexpr const char* names[] = {"automatic", "boxes", "hull", "convex_parts"};
    return names[static_cast<int>(info.param)];
}

INSTANTIATE_TEST_SUITE_P(Shapes, Reproducibility,
                         testing::Values(CollisionShape::automatic, CollisionShape::boxes,
                                         CollisionShape::hull, CollisionShape::convex_parts),
                         nameOf);

}  // namespace
