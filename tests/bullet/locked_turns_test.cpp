// Bodies that the app's angular factor keeps from turning: characters that stay upright, games in a plane.

#include "bullet/island/contact_motion.h"
#include "bullet/plate_of_the_app.h"
#include "bullet/world/conversions.h"

namespace {

using namespace sherd;
using namespace sherd::bullet_tests;

TEST(LockedTurns, APartnerInItsAxesGivesWayAsBulletHasIt) {
    TestWorld scene;
    for (const btVector3& factor :
         {btVector3(1, 1, 1), btVector3(0, 0, 1), btVector3(0, 0, 0), btVector3(0, 0, 0.25f)}) {
        btRigidBody* box = scene.addBox(3, btVector3(0.1f, 0.3f, 0.2f), btVector3(1, 2, 3));
        btTransform turned = box->getWorldTransform();
        turned.setRotation(btQuaternion(btVector3(0, 0, 1), 0.7f));
        box->setCenterOfMassTransform(turned);
        box->updateInertiaTensor();
        box->setAngularFactor(factor);
        const btVector3 arm(0.05f, 0.2f, 0), point = box->getCenterOfMassPosition() + arm, push(0, 2, 0);
        const btTransform frame(btQuaternion(btVector3(1, 1, 0).normalized(), 0.4f), btVector3(0.3f, 0, 1));
        const Mobility mobility = mobilityOf(*box, frame, point);
        box->applyImpulse(push, arm);
        const Vec3 moved = mobility.at(fromBullet(frame * point)) * fromBullet(frame.getBasis() * push);
        const btVector3 in_world = frame.getBasis().transpose() *
                                   btVector3(btScalar(moved.x()), btScalar(moved.y()), btScalar(moved.z()));
        EXPECT_LT((in_world - box->getVelocityInLocalPoint(arm)).length(), 1e-5) << factor.z();
    }
}

/// Energy that a ball of 50 kg and 1 m/s brings to the edge of a plate that floats, J.
double broughtToTheEdge(const btVector3& factor) {
    constexpr double dt = 1.0 / 240;
    TestWorld scene;
    scene.world->setGravity(btVector3(0, 0, 0));
    PlateOfTheApp plate(scene, btVector3(0, 0, 0));
    plate.box->setAngularFactor(factor);
    scene.addBall(50, 0.1, btVector3(0.28f, 0, 0.132f), btVector3(0, 0, -1));
    return impactOf(plate.strikeOfStep(dt), 0).energy();
}

TEST(LockedTurns, AStruckBodyGivesWayByItsMassAlone) {
    const double mass = plate(crumbly()).mass(), both = mass * 50 / (mass + 50);
    EXPECT_NEAR(broughtToTheEdge(btVector3(0, 0, 0)), 0.5 * both, 0.01 * both);
    EXPECT_LT(broughtToTheEdge(btVector3(1, 1, 1)), 0.8 * 0.5 * both);
    EXPECT_NEAR(broughtToTheEdge(btVector3(1, 0, 0)), 0.5 * both, 0.01 * both) << "it would turn about y";
}

// As in a game in a plane. Pieces have their principal axes anywhere, and Bullet's solver turned them about
// the free axis for what it left out of the others: they flew off at any speed.
TEST(LockedTurns, PiecesInAPlaneComeToRestInIt) {
    TestWorld scene;
    scene.world->setGravity(btVector3(0, btScalar(-9.81), 0));
    scene.addBox(0, btVector3(50, 1, 50), btVector3(0, -1, 0));
    FractureWorld fracture(scene.world.get());
    const auto tile = BreakableAsset::fromMesh(shapes::box(Vec3(-0.3, -0.3, -0.1), Vec3(0.3, 0.3, 0.1)),
                                               Material::plaster(), Settings::forQuality(Quality::preview));
    ASSERT_TRUE(tile.ok()) << tile.error();
    for (const int i : {0, 1, 2}) {
        BodyOptions options;
        options.start = btTransform(btQuaternion(btVector3(0, 0, 1), btScalar(0.2 * i)),
                                    btVector3(btScalar(1.2 * i), btScalar(0.5), 0));
        options.velocity = btVector3(0, -7, 0);
        btRigidBody* body = fracture.add(tile.value(), options).value();
        body->setLinearFactor(btVector3(1, 1, 0));
        body->setAngularFactor(btVector3(0, 0, 1));
    }
    double fastest_m_s = 0, out_of_plane_m_s = 0;
    for (int step = 0; step < 360; ++step) {
        scene.step(1, 1.0 / 120);
        for (const BlowEvent& event : fracture.takeEvents())
            EXPECT_LT(event.momentum_error_rel, 1e-3) << "generation " << event.generation;
        for (const btRigidBody* body : fracture.bodies()) {
            fastest_m_s = std::max(fastest_m_s, double(body->getLinearVelocity().length()));
            out_of_plane_m_s = std::max(out_of_plane_m_s, std::abs(double(body->getLinearVelocity().z())));
        }
    }
    EXPECT_GT(fracture.bodies().size(), 30u);
    EXPECT_LT(fastest_m_s, 9);
    EXPECT_LT(out_of_plane_m_s, 1e-5);
    for (const btRigidBody* body : fracture.bodies()) EXPECT_LT(body->getLinearVelocity().length(), 1);
}

}  // namespace
