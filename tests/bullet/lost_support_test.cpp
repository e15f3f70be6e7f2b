// What sleeps on a held body, or hangs on it, comes down when the body breaks or is removed. Bullet itself
// wakes what a moving fragment touches, and nothing else.

#include "bullet/support.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

/// A console that sticks out of a wall at x = 0; the wall holds the part of it that lies inside.
BreakableAsset console(Debris debris) {
    Settings settings = coarse(0.02);
    settings.fracture.debris = debris;
    // Of 3.2e-3; what sticks out has 1.1e-3.
    settings.fracture.smallest_fragment_m3 = debris == Debris::dropped ? 1.2e-3 : 1e-5;
    const auto asset =
        BreakableAsset::fromMesh(shapes::box(Vec3(-0.6, -0.03, -0.03), Vec3(0.3, 0.03, 0.03), 15, 1, 1),
                                 Material::plaster(), settings);
    EXPECT_TRUE(asset.ok()) << asset.error();
    const auto held = asset.value().anchored({BoxRegion{{-0.6, -1, -1}, {0, 1, 1}}});
    EXPECT_TRUE(held.ok()) << held.error();
    return held.value();
}

/// Two consoles, a shelf on them, and a lamp that hangs on a joint of the left one, far from all that falls;
/// shelf and lamp sleep.
struct Room {
    explicit Room(Debris debris = Debris::unbreakable) {
        scene.world->setGravity(btVector3(0, 0, -9.81f));
        const BreakableAsset asset = console(debris);
        left = fracture.add(asset, at(0, -0.4f, 1)).value();
        fracture.add(asset, at(0, 0.4f, 1)).value();
        shelf = scene.addBox(3, btVector3(0.09f, 0.5f, 0.01f), btVector3(0.2f, 0, 1.0405f));
        lamp = scene.addBall(0.1, 0.03, btVector3(0, -3, 0.8f));
        const btVector3 hook(0, -3, 0.9f);
        joint = std::make_unique<btPoint2PointConstraint>(*left, *lamp,
                                                          left->getWorldTransform().inverse() * hook,
                                                          lamp->getWorldTransform().inverse() * hook);
        scene.world->addConstraint(joint.get(), true);
        scene.step(480);
        EXPECT_TRUE(fracture.takeEvents().empty()) << "they carry the shelf";
        for (btRigidBody* body : {shelf, lamp}) {
            body->clearForces();
            body->setLinearVelocity(btVector3(0, 0, 0));
            body->setAngularVelocity(btVector3(0, 0, 0));
            body->setActivationState(ISLAND_SLEEPING);
        }
        EXPECT_NEAR(heightOf(shelf), 1.04, 0.005);
        EXPECT_NEAR(heightOf(lamp), 0.8, 0.005);
    }
    static btScalar heightOf(const btRigidBody* body) { return body->getCenterOfMassPosition().z(); }

    /// The left console breaks; nothing that moves strikes it.
    BlowEvent breakLeft() {
        Push push;
        push.point = btVector3(0.2f, -0.4f, 0.97f);
        push.impulse_n_s = btVector3(0, 0, -30);
        push.speed_m_s = 10;
        EXPECT_TRUE(fracture.applyBlow(left, push).ok());
        const std::vector<BlowEvent> events = fracture.takeEvents();
        EXPECT_EQ(events.size(), 1u);
        EXPECT_EQ(events.front().outcome, Outcome::broke) << events.front().message;
        return events.front();
    }
    void expectAllDown() {
        scene.step(240);
        EXPECT_LT(heightOf(shelf), 0.94) << "the shelf sleeps on in the air";
        EXPECT_LT(heightOf(lamp), 0.7) << "the lamp sleeps on in the air";
    }

    TestWorld scene;
    FractureWorld fracture{scene.world.get()};
    btRigidBody *left = nullptr, *shelf = nullptr, *lamp = nullptr;
    std::unique_ptr<btPoint2PointConstraint> joint;
};

TEST(LostSupport, OfABrokenConsole) {
    Room room;
    const BlowEvent event = room.breakLeft();
    EXPECT_EQ(event.removed_constraints, std::vector<btTypedConstraint*>{room.joint.get()});
    room.expectAllDown();
}

TEST(LostSupport, OfAConsoleWhoseLoosePiecesAreDropped) {
    Room room(Debris::dropped);
    for (const btRigidBody* piece : room.breakLeft().fragments)
        EXPECT_TRUE(piece->isStaticObject()) << "no piece is to wake what was held";
    room.expectAllDown();
}

TEST(LostSupport, OfARemovedConsole) {
    Room room;
    room.fracture.remove(room.left);
    room.expectAllDown();
}

}  // namespace
