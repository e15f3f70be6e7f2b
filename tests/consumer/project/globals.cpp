// A program whose world is a global: it ends with bodies in the world, blows that wait, and threads at work,
// after what the library keeps for the whole program was made.

#include <btBulletDynamicsCommon.h>
#include <sherd/sherd.h>

#include <cstdio>

namespace {

btBoxShape slab(btVector3(50, 50, 0.5f));
btRigidBody ground(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &slab));
btDefaultCollisionConfiguration configuration;
btCollisionDispatcher dispatcher(&configuration);
btDbvtBroadphase broadphase;
btSequentialImpulseConstraintSolver solver;
btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
sherd::FractureWorld fracture(&world);

}  // namespace

int main() {
    world.setGravity(btVector3(0, 0, -9.81f));
    ground.translate(btVector3(0, 0, -0.5f));
    world.addRigidBody(&ground);
    sherd::TriangleMesh plate;
    for (const double z : {0.0, 0.02})
        for (const auto& [x, y] : {std::pair{-0.2, -0.2}, {0.2, -0.2}, {0.2, 0.2}, {-0.2, 0.2}})
            plate.vertices.emplace_back(x, y, z);
    plate.triangles = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                       {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
    const auto asset = sherd::BreakableAsset::fromMesh(plate, sherd::Material::plaster());
    if (!asset) {
        std::puts(asset.error().c_str());
        return 1;
    }
    for (int i = 0; i < 8; ++i)
        if (!fracture.add(asset.value(), btTransform(btQuaternion(btVector3(1, 0, 0), 1),
                                                     btVector3(btScalar(i), 0, btScalar(2)))))
            return 1;
    // The first pieces have just broken off and lie on others when it ends.
    for (int step = 0; step < 240; ++step) world.stepSimulation(btScalar(1) / 240, 0);
    std::printf("%lld blows, %zu bodies\n", fracture.counts().seen, fracture.bodies().size());
    return fracture.bodies().size() > 8 ? 0 : 1;
}
