#include "bullet/island/other_joints.h"

#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyFixedConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBodyPoint2Point.h>
#include <BulletDynamics/Featherstone/btMultiBodySliderConstraint.h>
#include <BulletSoftBody/btSoftBody.h>

#include <algorithm>

namespace sherd {

namespace {

/// The rigid bodies of a constraint are protected members; a derived class may name them.
template <class Constraint>
class RigidBodiesOf : private Constraint {
  public:
    RigidBodiesOf() = delete;
    static void collect(const btMultiBodyConstraint& constraint, std::vector<btRigidBody*>& bodies) {
        const auto* kind = dynamic_cast<const Constraint*>(&constraint);
        if (!kind) return;
        for (btRigidBody* body :
             {kind->*(&RigidBodiesOf::m_rigidBodyA), kind->*(&RigidBodiesOf::m_rigidBodyB)})
            if (body) bodies.push_back(body);
    }
};

void freeAnchors(btSoftBody& soft, const btRigidBody& body) {
    for (int i = soft.m_anchors.size() - 1; i >= 0; --i) {
        if (soft.m_anchors[i].m_body != &body) continue;
        soft.m_anchors[i].m_node->m_battach = 0;
        soft.m_anchors.removeAtIndex(i);
    }
}

/// The contacts of a soft body are found before a step is solved and solved after it.
void dropContacts(btSoftBody& soft, const btRigidBody& body) {
    for (int i = soft.m_rcontacts.size() - 1; i >= 0; --i)
        if (soft.m_rcontacts[i].m_cti.m_colObj == &body) soft.m_rcontacts.removeAtIndex(i);
}

}  // namespace

std::vector<btRigidBody*> rigidBodiesOf(const btMultiBodyConstraint& constraint) {
    std::vector<btRigidBody*> bodies;
    RigidBodiesOf<btMultiBodyPoint2Point>::collect(constraint, bodies);
    RigidBodiesOf<btMultiBodyFixedConstraint>::collect(constraint, bodies);
    RigidBodiesOf<btMultiBodySliderConstraint>::collect(constraint, bodies);
    return bodies;
}

std::vector<btMultiBodyConstraint*> removeMultiBodyConstraints(btDiscreteDynamicsWorld& world,
                                                               const btRigidBody& body) {
    std::vector<btMultiBodyConstraint*> removed;
    auto* multi_world = dynamic_cast<btMultiBodyDynamicsWorld*>(&world);
    if (!multi_world) return removed;
    for (int i = 0; i < multi_world->getNumMultiBodyConstraints(); ++i) {
        btMultiBodyConstraint* constraint = multi_world->getMultiBodyConstraint(i);
        const std::vector<btRigidBody*> bodies = rigidBodiesOf(*constraint);
        if (std::find(bodies.begin(), bodies.end(), &body) != bodies.end()) removed.push_back(constraint);
    }
    for (btMultiBodyConstraint* constraint : removed) multi_world->removeMultiBodyConstraint(constraint);
    return removed;
}

void detachSoftBodies(btDiscreteDynamicsWorld& world, const btRigidBody& body) {
    const auto& objects = world.getCollisionObjectArray();
    for (int i = 0; i < objects.size(); ++i) {
        btSoftBody* soft = btSoftBody::upcast(objects[i]);
        if (!soft) continue;
        freeAnchors(*soft, body);
        dropContacts(*soft, body);
        for (int k = 0; k < soft->m_joints.size(); ++k)
            for (btSoftBody::Body& end : soft->m_joints[k]->m_bodies)
                if (end.m_collisionObject == &body) end = btSoftBody::Body();
    }
}

}  // namespace sherd
