#pragma once

#include <LinearMath/btTransform.h>

#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "bullet/bodies/body_token.h"

class btCollisionObject;
class btDiscreteDynamicsWorld;
class btPersistentManifold;

namespace sherd {

/// Pairs of bodies that overlap when one of them is created: hulls of neighbouring fragments penetrate each
/// other, and those of plates in a stack, and Bullet would push them apart. The penetration at birth is
/// allowed; the allowance shrinks as the bodies separate. Contacts are solved all the while, so that
/// fragments support each other as they did when they were one body.
class BirthOverlaps {
  public:
    /// Registers every pair of a new body and a body that it may overlap, after broadphase and narrowphase
    /// ran for it.
    void add(btDiscreteDynamicsWorld& world, const std::vector<btCollisionObject*>& new_bodies);
    /// Registers pairs of dynamic bodies that have contacts deeper than 0, those for which `is_allowed`.
    void addOverlapping(
        btDiscreteDynamicsWorld& world,
        const std::function<bool(const btCollisionObject&, const btCollisionObject&)>& is_allowed);
    /// Takes over what is allowed in another world between bodies that have stand-ins in this one; nullptr
    /// for others.
    void copy(const BirthOverlaps& other,
              const std::function<btCollisionObject*(const btCollisionObject*)>& stand_in);
    /// Whether some penetration of two bodies is allowed.
    bool allows(const btCollisionObject& a, const btCollisionObject& b) const;
    /// Subtracts the allowed penetration from the contacts of the current step. To be called just before a
    /// solve; calling it twice has no further effect.
    void applyAllowances(btDiscreteDynamicsWorld& world);

  private:
    struct Pair {
        const btCollisionObject* bodies[2] = {nullptr, nullptr};  // in the order of their proxies
        btScalar radius = 0;                                      // of the second body about its origin
        btTransform before,
            now;  // of the second body in the frame of the first, at the last update and at this one
        btScalar measured_m = 0;  // depth of the deepest contact now
        btScalar closed_m = 0;  // the part of it that the bodies moved into each other since the last update
        btScalar depth_m = 0;   // measured depth, without changes that the motion cannot explain
        btScalar allowance_m = 0;  // the part of the depth that is allowed
        bool is_nested = false;    // the bodies were put into each other
    };
    /// By what distinguishes the bodies, in the order in which they were given it: not by their addresses,
    /// which differ from run to run, and may be those of other bodies later.
    using Key = std::pair<BodyToken, BodyToken>;

    /// Of bodies that move. None if one cannot be told apart later.
    static std::optional<std::pair<Key, Pair>> pairOf(btCollisionObject& a, btCollisionObject& b);
    static void measure(Pair& pair, const btPersistentManifold& manifold);
    static void update(Pair& pair);
    static bool isAwake(const Pair& pair);
    void dropSeparated(const btDiscreteDynamicsWorld& world);

    std::map<Key, Pair> pairs_;  // pairs are independent of each other, so their order has no effect
};

}  // namespace sherd
