#include "bullet/moved_ground.h"

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <algorithm>

#include "bullet/ground_surface.h"

namespace sherd {

namespace {

template <class Visit>
void forEachKinematicSurface(const btDiscreteDynamicsWorld& world, const Visit& visit) {
    const auto& objects = world.getCollisionObjectArray();
    for (int i = 0; i < objects.size(); ++i)
        if (objects[i]->isKinematicObject() && isGroundSurface(*objects[i])) visit(*objects[i]);
}

}  // namespace

std::vector<MovedGround::Surface> MovedGround::since(const btDiscreteDynamicsWorld& world) const {
    std::vector<Surface> surfaces;
    if (stood_.empty()) return surfaces;
    forEachKinematicSurface(world, [&](const btCollisionObject& ground) {
        const auto known = std::find_if(stood_.begin(), stood_.end(),
                                        [&](const Stood& stood) { return stood.ground == &ground; });
        const btTransform& here = ground.getWorldTransform();
        if (known == stood_.end() || known->where == here) return;
        surfaces.push_back({&ground, here * known->where.inverse()});
    });
    return surfaces;
}

void MovedGround::note(const btDiscreteDynamicsWorld& world) {
    stood_.clear();
    forEachKinematicSurface(world, [&](const btCollisionObject& ground) {
        stood_.push_back({&ground, ground.getWorldTransform()});
    });
}

}  // namespace sherd
