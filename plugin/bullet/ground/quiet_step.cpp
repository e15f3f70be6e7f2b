#include "bullet/ground/quiet_step.h"

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include "bullet/bodies/breakable.h"

namespace sherd {

namespace {

constexpr double of_one_step = 4;  // a strike is faster by up to half its speed, which comes from gravity

/// At most, J, with what the app's forces bring in the step. Gravity brings nothing to what rests.
double energyOf(const btRigidBody& body, btScalar time_step_s) {
    const btVector3 pushed = body.getTotalForce() * body.getInvMass() - body.getGravity(),
                    turned = body.getInvInertiaTensorWorld() * body.getTotalTorque();
    const btScalar speed = body.getLinearVelocity().length() + time_step_s * pushed.length(),
                   spin = body.getAngularVelocity().length() + time_step_s * turned.length();
    const btVector3 inertia = body.getLocalInertia();
    const double largest = inertia[inertia.maxAxis()];
    return 0.5 * (double(speed) * speed / body.getInvMass() + largest * spin * spin);
}

/// What the app moves is often flagged as static, too: so the manual of Bullet has it.
bool staysPut(const btCollisionObject& object) {
    return object.isStaticObject() && !object.isKinematicObject();
}

bool moves(const btCollisionObject& object) {
    return !object.getInterpolationLinearVelocity().isZero() ||
           !object.getInterpolationAngularVelocity().isZero();
}

}  // namespace

bool anythingAwake(const btDiscreteDynamicsWorld& world) {
    const auto& objects = world.getCollisionObjectArray();
    for (int i = 0; i < objects.size(); ++i)
        if (objects[i]->isActive() && !staysPut(*objects[i])) return true;
    return false;
}

bool nothingCanBreak(const btDiscreteDynamicsWorld& world, const BreakableRegistry& breakables,
                     double time_step_s) {
    const double least = breakables.leastEnergyInWorld();
    double sum = 0;
    const auto& objects = world.getCollisionObjectArray();
    for (int i = 0; i < objects.size(); ++i) {
        const btCollisionObject& object = *objects[i];
        if (!object.isActive() || staysPut(object)) continue;
        const btRigidBody* body = btRigidBody::upcast(&object);
        if (object.isKinematicObject() ? moves(object) : !body) return false;
        if (body && body->getInvMass() > 0) sum += energyOf(*body, static_cast<btScalar>(time_step_s));
        if (!(of_one_step * sum < least)) return false;
    }
    return true;
}

}  // namespace sherd
