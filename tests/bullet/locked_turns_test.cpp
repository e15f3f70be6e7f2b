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

}  // namespace
