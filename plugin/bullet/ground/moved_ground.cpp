#include "bullet/ground/moved_ground.h"

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <algorithm>

#include "bullet/ground/ground_surface.h"

namespace sherd {

namespace {

template <class Visit>
void forEachKinematicSurface(const btDiscreteDynamicsWorld& world, const Visit& visit) {
    const auto& objects = world.getCollisionObjectArray();
    for (int i = 0; i < objects.size(); ++i)
        if (objects[i]->isKinematicObject() && isGroundSurface(*objects[i])) visit(*objects[i]);
}

}  // namespace

btVector3 MovedSurface::carry(const btVector3& point) const {
    constexpr btScalar furthest = btScalar(0.5);  // m
    const btVector3 carried = moved * point;
    return (carried - point).length2() > furthest * furthest ? point : carried;
}

MovedSurfaces MovedGround::since(const btDiscreteDynamicsWorld& world) const {
    MovedSurfaces surfaces;
    if (stood_.empty()) return surfaces;
    auto likely = stood_.begin();
    forEachKinematicSurface(world, [&](const btCollisionObject& ground) {
        const auto is_it = [&](const Stood& stood) { return stood.ground == &ground; };
        auto known = std::find_if(likely, stood_.end(), is_it);
        if (known == stood_.end()) known = std::find_if(stood_.begin(), likely, is_it);
        if (known == stood_.end() || !is_it(*known)) return;
        likely = known + 1;
        const btTransform& here = ground.getWorldTransform();
        if (!(known->where == here)) surfaces.push_back({&ground, here * known->where.inverse()});
    });
    return surfaces;
}

void MovedGround::endStep(const btDiscreteDynamicsWorld& world) {
    surfaces_.clear();
    stood_.clear();
    forEachKinematicSurface(world, [&](const btCollisionObject& ground) {
        stood_.push_back({&ground, ground.getWorldTransform()});
    });
}

}  // namespace sherd
