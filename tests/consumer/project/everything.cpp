// A stranger's program that uses every part of the world's interface, and says so where something is not as
// the headers promise.

#include <btBulletDynamicsCommon.h>
#include <sherd/sherd.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace {

void check(bool holds, const char* what) {
    if (holds) return;
    std::printf("not so: %s\n", what);
    std::exit(1);
}

/// A motion state of the app's own: Bullet writes where to draw the body.
struct DrawnObject : btMotionState {
    btTransform place = btTransform::getIdentity();
    void getWorldTransform(btTransform& centre_of_mass) const override { centre_of_mass = place; }
    void setWorldTransform(const btTransform& centre_of_mass) override { place = centre_of_mass; }
};

btTransform at(btScalar x, btScalar y, btScalar z) {
    return btTransform(btQuaternion::getIdentity(), btVector3(x, y, z));
}

struct World {
    World() {
        world.setGravity(btVector3(0, 0, -9.81f));
        floor.translate(btVector3(0, 0, -0.5f));
        world.addRigidBody(&floor);
    }
    ~World() { world.removeRigidBody(&floor); }
    btBoxShape slab{btVector3(50, 50, 0.5f)};
    btRigidBody floor{btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &slab)};
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
};

/// The first event that tells of a break, and how many others there were.
std::vector<sherd::BlowEvent> breaks(sherd::FractureWorld& fracture) {
    std::vector<sherd::BlowEvent> broken;
    for (sherd::BlowEvent& event : fracture.takeEvents())
        if (event.outcome == sherd::Outcome::broke) broken.push_back(std::move(event));
    return broken;
}

}  // namespace

int main() {
    sherd::Settings settings = sherd::Settings::forQuality(sherd::Quality::preview);
    settings.strength.seed = 3;
    settings.strength.field = [](const sherd::Vec3& x) { return x.x() > 0 ? 1.0 : 0.8; };
    settings.fracture.debris = sherd::Debris::merged;
    const auto made = sherd::BreakableAsset::fromMesh(sherd::boxMesh({0.3, 0.3, 0.02}),
                                                      sherd::Material::ceramic(), settings);
    check(made.ok(), made.error().c_str());
    const sherd::BreakableAsset asset = made.value();
    std::thread worker([&] { check(asset.prepare().ok(), "an asset is prepared on another thread"); });

    World scene;
    sherd::FractureWorld fracture(&scene.world);
    worker.join();

    // Fragments get motion states of the app's, and say whose they are.
    std::map<const btRigidBody*, std::unique_ptr<DrawnObject>> drawn;
    fracture.onFragment([&](sherd::FragmentBirth& birth) {
        auto object = std::make_unique<DrawnObject>();
        birth.body.setMotionState(object.get());
        birth.body.setUserIndex(birth.parent.getUserIndex() + 1);
        birth.name += "/" + std::to_string(birth.event.fragments.size());
        birth.collision_mask &= ~32;
        drawn[&birth.body] = std::move(object);
    });

    // A falling tile, with all that a body may be given.
    DrawnObject falling;
    sherd::BodyOptions options(btTransform(btQuaternion(btVector3(1, 0, 0), 1.2f), btVector3(0, 0, 2)));
    options.velocity = btVector3(0, 0, -3);
    options.angular_velocity = btVector3(0, 0.5f, 0);
    options.collision_group = 4;
    options.collision_mask = -1;
    options.user_pointer = &scene;
    options.user_index = 10;
    options.motion_state = &falling;
    options.name = "falling";
    options.seed = 7;
    options.fracture = asset.settings().fracture;
    options.fracture->fragment_count = 6;
    options.fracture->collision_shape = sherd::CollisionShape::hull;
    const auto added = fracture.add(asset, options);
    check(added.ok(), added.error().c_str());
    check(fracture.name(added.value()) == "falling", "a body keeps its name");
    std::vector<sherd::BlowEvent> broken;
    for (int frame = 0; frame < 240 && broken.empty(); ++frame) {
        scene.world.stepSimulation(1.0f / 60, 10, 1.0f / 240);
        broken = breaks(fracture);
    }
    check(!broken.empty(), "the tile breaks on the floor");
    {
        const sherd::BlowEvent& event = broken.front();
        check(event.name == "falling", "an event has the body's name");
        check(event.velocity.z() < -3, "an event tells how the body moved");
        check(event.asset.surface().triangles.size() == 12, "an event carries the asset");
        check(event.body->getUserPointer() == &scene, "the broken body is still there to be asked");
        check(event.fragments.size() >= 2, "there are fragments");
        const btRigidBody* piece = event.fragments.front();
        check(piece->getUserIndex() == 11, "the callback's user index is kept");
        check(piece->getBroadphaseHandle()->m_collisionFilterGroup == 4, "fragments inherit the group");
        check(piece->getBroadphaseHandle()->m_collisionFilterMask == ~32, "the callback's mask is kept");
        check(fracture.name(piece) == "falling/0", "the callback's name is kept");
        check(drawn.count(piece) == 1, "fragments have the app's motion states");
        check(fracture.renderTransform(piece).getOrigin().distance(
                  fracture.assetTransform(piece).getOrigin()) < 0.1,
              "a fragment is drawn where it is");
        std::printf("%s broke into %zu pieces\n", event.name.c_str(), event.fragments.size());
    }

    // Another body of the same asset, broken by a bullet between two steps, otherwise than the first.
    sherd::BodyOptions target(at(5, 0, 1));
    target.fracture = asset.settings().fracture;
    target.fracture->fragment_count = 3;
    btRigidBody* shot = fracture.add(asset, target).value();
    const sherd::Push bullet{btVector3(5, 0, 1.01f), btVector3(0, 0, -3.2f), 0.005, 400};
    check(fracture.applyBlow(shot, bullet).ok(), "a bullet may be shot at a body");
    broken = breaks(fracture);
    check(broken.size() == 1, "the bullet breaks it at once");
    std::printf("shot into %zu pieces\n", broken.front().fragments.size());

    // A wall of the app's own and a row of tiles, and an explosion between them.
    btBoxShape brick(btVector3(0.2f, 0.05f, 0.2f));
    btVector3 inertia;
    brick.calculateLocalInertia(20, inertia);
    btRigidBody wall(btRigidBody::btRigidBodyConstructionInfo(20, nullptr, &brick, inertia));
    wall.setCenterOfMassTransform(at(-5, 0.4f, 0.2f));
    scene.world.addRigidBody(&wall);
    sherd::BreakableOptions wall_options;
    wall_options.name = "wall";
    const auto breakable = fracture.makeBreakable(&wall, sherd::Material::plaster(), settings, wall_options);
    check(breakable.ok(), breakable.error().c_str());
    for (int i = 0; i < 3; ++i) fracture.add(asset, at(-5 + 0.4f * btScalar(i), -0.3f, 0.2f)).value();
    const auto struck = sherd::explode(fracture, {btVector3(-5, 0, 0.2f), 300, 3});
    check(struck.ok() && struck.value() == 4, "an explosion strikes what is near");
    broken = breaks(fracture);
    check(!broken.empty(), "an explosion breaks what is near");
    std::printf("%zu of %d broke in the explosion\n", broken.size(), struck.value());

    // Tiles that stand on edge, held at their feet: static until they are struck, and what is held stays.
    const sherd::BoxRegion foot{{-0.15, -0.15, -0.01}, {0.15, -0.1, 0.01}};
    const btTransform upright(btQuaternion(btVector3(1, 0, 0), SIMD_HALF_PI), btVector3(10, 0, 0.15f));
    sherd::BodyOptions held(upright);
    held.supports = {foot};
    const auto fence = fracture.add(asset, held);
    check(fence.ok(), fence.error().c_str());
    check(fence.value()->isStaticObject(), "a body with supports is static");
    check(fracture.asset(fence.value())->supports().size() == 1,
          "the asset of a held body names its supports");
    check(asset.supports().empty(), "the asset that it was made of stays free");
    const auto anchored = asset.anchored({foot});
    check(anchored.ok(), anchored.error().c_str());
    check(anchored.value().supports().size() == 1, "an anchored asset has supports");
    sherd::BodyOptions beside(upright);
    beside.start.setOrigin(btVector3(11, 0, 0.15f));
    const auto second = fracture.add(anchored.value(), beside);
    check(second.ok() && second.value()->isStaticObject(), "bodies of an anchored asset are static");
    btBoxShape post_shape(btVector3(0.1f, 0.05f, 0.3f));
    btRigidBody post(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &post_shape));
    post.setCenterOfMassTransform(at(12, 0, 0.3f));
    scene.world.addRigidBody(&post);
    check(!fracture.makeBreakable(&post, sherd::Material::plaster(), settings).ok(),
          "a static body without supports is refused");
    sherd::BreakableOptions post_options;
    post_options.supports = {sherd::BoxRegion{{-0.1, -0.05, -0.3}, {0.1, 0.05, -0.2}}};
    const auto held_post = fracture.makeBreakable(&post, sherd::Material::plaster(), settings, post_options);
    check(held_post.ok(), held_post.error().c_str());
    for (const btScalar x : {btScalar(10), btScalar(11)}) {
        btRigidBody* const tile_there = x < 10.5f ? fence.value() : second.value();
        const sherd::Push at_the_top{btVector3(x, -0.01f, 0.2f), btVector3(0, 4, 0), 0.01, 400};
        check(fracture.applyBlow(tile_there, at_the_top).ok(), "a held body may be struck");
        broken = breaks(fracture);
        check(broken.size() == 1, "a held tile breaks");
        std::size_t stay = 0;
        for (const btRigidBody* piece : broken.front().fragments) stay += piece->isStaticObject();
        check(stay >= 1 && stay < broken.front().fragments.size(), "the foot stays, and the rest comes off");
        std::printf("%zu of %zu pieces stay\n", stay, broken.front().fragments.size());
    }

    // What cannot be done is answered with a sentence.
    check(!asset.anchored({sherd::SphereRegion{{9, 9, 9}, 0.1}}).ok(),
          "a support that touches nothing is refused");
    held.velocity = btVector3(1, 0, 0);
    check(!fracture.add(asset, held).ok(), "a body with supports cannot move");
    sherd::BodyOptions scaled;
    scaled.start.setBasis(scaled.start.getBasis().scaled(btVector3(2, 2, 2)));
    check(!fracture.add(asset, scaled).ok(), "a scaled start is refused");
    check(!fracture.applyBlow(&scene.floor, bullet).ok(), "a floor cannot be struck");

    for (int frame = 0; frame < 30; ++frame) scene.world.stepSimulation(1.0f / 60, 10, 1.0f / 240);
    fracture.onFragment(nullptr);
    const sherd::BlowCounts counts = fracture.counts();
    check(counts.solved() > 0 && counts.events_dropped == 0, "blows are counted");
    const sherd::WorldTimes times = fracture.times();
    check(times.stages() > 0 && times.stages() <= times.whole, "every stage is timed, and none twice");
    for (btRigidBody* body : fracture.bodies())
        if (body != &wall && body != &post) fracture.remove(body);
    check(fracture.bodies().size() <= 2, "bodies can be removed");
    scene.world.removeRigidBody(&wall);
    scene.world.removeRigidBody(&post);
    std::puts("all as promised");
}
