#pragma once

#include <LinearMath/btTransform.h>
#include <sherd/breakable_asset.h>
#include <sherd/events.h>

#include <memory>
#include <vector>

class btCompoundShape;
class btDiscreteDynamicsWorld;
class btRigidBody;

namespace sherd {

/// Makes bodies of a Bullet world breakable. Puts itself around the world's constraint solver when made and
/// takes itself out when destroyed; the world must outlive it. Breaks happen inside `stepSimulation`.
class FractureWorld {
  public:
    explicit FractureWorld(btDiscreteDynamicsWorld* world);
    ~FractureWorld();
    FractureWorld(const FractureWorld&) = delete;
    FractureWorld& operator=(const FractureWorld&) = delete;

    /// Adds a body to the world: a btRigidBody with the shape that its settings ask for (a btCompoundShape,
    /// or a btConvexHullShape for `CollisionShape::hull`), owned by this object. `start` places the origin of
    /// the asset's own coordinates. Returns nullptr while the world is inside a step, or when the asset's
    /// solid cannot be sampled; `lastError` says which.
    btRigidBody* add(const BreakableAsset& asset, const btTransform& start);

    /// Makes a body of the app's, with a compound of convex children (or one convex shape), breakable. The
    /// app goes on owning it; when it breaks it is removed from the world. Its mass stays what it was. Remove
    /// it from the world before you delete it.
    Status makeBreakable(btRigidBody* body, const Material& material, const Settings& settings = {});

    /// Takes a body that was made here (or a fragment) out of the world and deletes it.
    void remove(btRigidBody* body);

    /// Takes the blows that were solved since the last call, in order. Call it after every step or so: events
    /// that are not taken are kept, and with them the bodies that broke.
    std::vector<BreakEvent> events();

    BlowCounts counts() const;

    /// The breakable bodies that are in the world now, fragments included.
    std::vector<btRigidBody*> bodies() const;

    /// The asset of a breakable body (fragments have one of their own), for its surface; nullptr for other
    /// bodies.
    const BreakableAsset* asset(const btRigidBody* body) const;

    /// Maps the coordinates of `asset(body)->surface()` to the world, where the body is now.
    btTransform assetTransform(const btRigidBody* body) const;

    /// Why the last `add` returned nullptr.
    const std::string& lastError() const;

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace sherd
