#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <sherd/breakable_asset.h>

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "bullet/rigid_body_factory.h"

namespace sherd {

/// Tells a body of the app's from another one that was created at its address later.
struct Identity {
    int proxy = -1;  ///< unique id; Bullet gives a body a new one each time it is added to a world
    const btCollisionShape* shape = nullptr;
    btScalar inverse_mass = 0;

    static Identity of(const btRigidBody& body);
};

/// A body that can break, with its asset.
struct Breakable {
    explicit Breakable(const BreakableAsset& its_asset) : asset(its_asset) {}

    btRigidBody* body = nullptr;  ///< may be dangling if the app owns it and `in_world` is false: compare
                                  ///< only, never dereference
    BreakableAsset asset;
    btTransform body_from_asset = btTransform::getIdentity();
    OwnedBody owned;  ///< empty when the app owns the body
    std::uint64_t serial =
        0;  ///< counts the bodies of this world in the order in which they became breakable
    double unbreakable_until_s = 0;  ///< simulated time
    bool in_world = true;            ///< at the last syncWithWorld
    Identity identity;               ///< of an app's body, when it was made breakable

    bool ownedHere() const { return owned.body != nullptr; }
    /// The map from the asset's frame to the world, for a body that stands at `world_transform`.
    btTransform placed(const btTransform& world_transform) const { return world_transform * body_from_asset; }
};

/// The breakable bodies of one world, in the order in which they became breakable.
class BreakableRegistry {
  public:
    Breakable& add(std::unique_ptr<Breakable> breakable);
    /// `object` is alive.
    Breakable* find(const btCollisionObject* object) const;
    /// Removes and returns an entry; nullptr for other bodies.
    std::unique_ptr<Breakable> take(const btCollisionObject* object);
    /// Updates `in_world` of every entry. Bodies that the app removed from the world are dropped if the app
    /// owns them (they may be dead), and kept if they are ours.
    void syncWithWorld(const btAlignedObjectArray<btCollisionObject*>& in_world);

    const std::vector<std::unique_ptr<Breakable>>& all() const { return all_; }

  private:
    std::vector<std::unique_ptr<Breakable>> all_;
    std::unordered_map<const btCollisionObject*, Breakable*>
        by_object_;  // for look-up only; never iterated over
};

}  // namespace sherd
