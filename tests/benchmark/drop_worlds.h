#pragma once

#include <btBulletDynamicsCommon.h>
#include <sherd/sherd.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "benchmark/floor_world.h"
#include "fracture/breakable_solid.h"
#include "support/plain_twin.h"

namespace sherd::benchmarks {

inline constexpr double time_step_s = 1.0 / 240;
inline constexpr int orientations = 5;

/// On which pieces do not slide far.
struct World : FloorWorld {
    World() : FloorWorld(50) { floor.setFriction(1); }  // shards slide for metres
    void step() { world.stepSimulation(btScalar(time_step_s), 0); }
};

inline double kineticEnergy(const btRigidBody& body) {
    const btVector3 v = body.getLinearVelocity(), w = body.getAngularVelocity();
    return 0.5 * (v.length2() / body.getInvMass() + w.dot(body.getInvInertiaTensorWorld().inverse() * w));
}

inline double energy(const std::vector<btRigidBody*>& bodies) {
    double sum = 0;
    for (const btRigidBody* body : bodies)
        sum += kineticEnergy(*body) +
               gravity_m_s2 * body->getWorldTransform().getOrigin().z() / body->getInvMass();
    return sum;
}

inline btVector3 toBt(const Vec3& x) {
    return {btScalar(x.x()), btScalar(x.y()), btScalar(x.z())};
}

/// Just above the floor.
inline btTransform startOf(const TriangleMesh& surface, int orientation) {
    const Vec3 axes[orientations] = {{1, 0, 0}, {0.8, 0.6, 0}, {0, 1, 0.3}, {1, 1, 1}, {0, 0.2, 1}};
    const double angles[orientations] = {0.1, 0.7, 1.5, 2.4, 3.0};
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(angles[orientation], axes[orientation].normalized()));
    Eigen::AlignedBox3d box;
    for (const Vec3& v : surface.vertices) box.extend(turn * v);
    return btTransform(
        btQuaternion(btScalar(turn.x()), btScalar(turn.y()), btScalar(turn.z()), btScalar(turn.w())),
        toBt(Vec3(-box.center().x(), -box.center().y(), 0.01 - box.min().z())));
}

/// Of the surface of a body, in metres below the floor.
inline double depthOf(const TriangleMesh& surface, const btTransform& place) {
    double lowest = 0;
    for (const Vec3& v : surface.vertices) lowest = std::min(lowest, double((place * toBt(v)).z()));
    return -lowest;
}

/// The pieces where they are, with the shapes that they have, in a world of Bullet's alone.
class PlainTwin {
  public:
    PlainTwin(FractureWorld& fracture, CollisionShape shape) {
        for (const btRigidBody* piece : fracture.bodies()) {
            const BreakableSolid& solid = *fracture.asset(piece)->solid();
            solids_.push_back(fracture.asset(piece)->solid());
            pieces_.push_back(plainTwin(solid, shape));
            from_asset_.push_back(principalFrame(solid.moments()).body_from_asset);
            btRigidBody& twin = *pieces_.back().body;
            twin.setCenterOfMassTransform(piece->getWorldTransform());
            twin.setLinearVelocity(piece->getLinearVelocity());
            twin.setAngularVelocity(piece->getAngularVelocity());
            world_.world.addRigidBody(&twin);
        }
    }
    ~PlainTwin() {
        for (OwnedBody& piece : pieces_) world_.world.removeRigidBody(piece.body.get());
    }
    struct Rest {
        int awake = 0;
        double depth = 0;  ///< of the deepest vertex in the floor, m
        double rise = 0;   ///< of energy in a step, J
    };
    Rest run(int count) {
        Rest rest;
        std::vector<btRigidBody*> bodies;
        for (OwnedBody& piece : pieces_) bodies.push_back(piece.body.get());
        double before = energy(bodies);
        for (int i = 0; i < count; ++i) {
            world_.step();
            const double now = energy(bodies);
            rest.rise = std::max(rest.rise, now - before);
            before = now;
        }
        for (std::size_t p = 0; p < bodies.size(); ++p) {
            rest.awake += bodies[p]->isActive();
            const btTransform place = bodies[p]->getWorldTransform() * from_asset_[p];
            rest.depth = std::max(rest.depth, depthOf(solids_[p]->surface(), place));
        }
        return rest;
    }

  private:
    World world_;
    std::vector<std::shared_ptr<const BreakableSolid>> solids_;
    std::vector<btTransform> from_asset_;
    std::vector<OwnedBody> pieces_;
};

}  // namespace sherd::benchmarks
