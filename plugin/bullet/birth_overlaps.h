#pragma once

#include <LinearMath/btTransform.h>

#include <map>
#include <utility>
#include <vector>

class btCollisionObject;
class btDiscreteDynamicsWorld;
class btPersistentManifold;

namespace sherd {

/// Pairs that may have overlapped when one of them was born: hulls of neighbouring fragments reach into each
/// other. Bullet would push them apart. Instead each pair is forgiven the depth that it has, and forgiven
/// less as it parts; it collides all the while, so that pieces lie and push on each other as they did when
/// they were one body.
class BirthOverlaps {
  public:
    /// Takes in what newcomers to the world may overlap with, after broadphase and narrowphase saw them.
    void add(btDiscreteDynamicsWorld& world, const std::vector<btCollisionObject*>& newcomers);
    /// Takes the forgiven depth off the contacts that the step under way has found. For just before a solve;
    /// done twice it does no more than once.
    void forgive(btDiscreteDynamicsWorld& world);

  private:
    struct Pair {
        const btCollisionObject* bodies[2] = {nullptr,
                                              nullptr};  // in the order in which they came into the world
        int proxies[2] = {-1, -1};  // Bullet gives a new number whenever a body comes into a world
        btScalar radius = 0;        // of all of the second body about its origin
        btTransform before,
            now;  // of the second body in the frame of the first, at the last look and at this one
        btScalar measured_m = 0;  // depth of the deepest contact there is now
        btScalar closed_m = 0;    // what of it the bodies moved into each other since the last look
        btScalar depth_m = 0;     // without what cannot be
        btScalar forgiven_m = 0;  // of the depth
    };
    using Key = std::pair<const btCollisionObject*, const btCollisionObject*>;  // the lower address first

    static void measure(Pair& pair, const btPersistentManifold& manifold);
    static void update(Pair& pair);
    void dropParted(const btDiscreteDynamicsWorld& world);

    std::map<Key, Pair>
        pairs_;  // what is done to a pair does not depend on the others, so neither on their order
};

}  // namespace sherd
