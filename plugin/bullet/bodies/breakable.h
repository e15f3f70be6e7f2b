#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <sherd/breakable_asset.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "bullet/bodies/body_token.h"
#include "bullet/shapes/inner_ball.h"
#include "bullet/shapes/pooled.h"
#include "bullet/shapes/rigid_body_factory.h"
#include "bullet/shapes/shapes.h"
#include "core/damage/damaged_material.h"

namespace sherd {

/// Which bodies a body collides with; the defaults are Bullet's for bodies that move.
struct CollisionFilter {
    int group = btBroadphaseProxy::DefaultFilter;
    int mask = btBroadphaseProxy::AllFilter;

    /// Bullet's for a body that moves, or for one that does not.
    static CollisionFilter usual(bool is_static) {
        if (!is_static) return {};
        return {btBroadphaseProxy::StaticFilter,
                btBroadphaseProxy::AllFilter ^ btBroadphaseProxy::StaticFilter};
    }
    bool operator==(const CollisionFilter& other) const { return group == other.group && mask == other.mask; }
};

/// How a body came to where it is, in a world with ground that is a surface without an inside.
struct GroundWay {
    bool is_known = false;                                     ///< there was such ground in the last step
    btTransform from = btTransform::getIdentity(), to = from;  ///< before and after that
    btTransform clear_at = from;                               ///< where no ground was near it the last time
    double since_clear_s = std::numeric_limits<double>::infinity();

    /// Whether the body stands where the last step left it: the app may have moved it with its ground.
    bool isAt(const btTransform& place) const { return is_known && to == place; }
};

/// A body that can break, with its asset.
struct Breakable : Pooled {
    Breakable(const BreakableAsset& its_asset, std::shared_ptr<const FractureSettings> its_fracture)
        : asset(its_asset), fracture(std::move(its_fracture)) {}
    /// Keeps what joints of the app's need of the body.
    ~Breakable();
    Breakable(const Breakable&) = delete;
    Breakable& operator=(const Breakable&) = delete;

    btRigidBody* body = nullptr;  ///< may be dangling if the app owns it and `in_world` is false: compare
                                  ///< only, never dereference
    BreakableAsset asset;
    std::shared_ptr<const BreakableAsset> of_all_alike;  ///< kept for those that are to share it
    std::shared_ptr<const FractureSettings> fracture;    ///< how it breaks; shared with its fragments
    btTransform body_from_asset = btTransform::getIdentity();
    std::shared_ptr<const ConvexParts> made_of;  ///< of a body of the app's own, its shape as it was
    std::string name;
    std::optional<std::uint64_t> seed;  ///< given by the app, or derived from that of the body it was part of
    /// What blows that it held damaged of it, or of the body that it was part of; nullptr: nothing.
    std::shared_ptr<const DamagedMaterial> damaged;
    CollisionFilter filter;  ///< with which a fragment enters the world
    OwnedBody owned;         ///< empty when the app owns the body
    std::uint64_t serial =
        0;  ///< counts the bodies of this world in the order in which they became breakable
    double unbreakable_until_s = 0;  ///< simulated time
    /// A body that belongs to the blow that made a fragment, until a simulated time.
    struct Company {
        BodyToken body = no_token;
        double until_s = 0;
    };
    std::vector<Company> in_one_blow_with;
    std::vector<BodyToken> came_of;  ///< the bodies that it was part of
    double young_until_s = 0;        ///< simulated time; 0 for what is no fragment
    bool in_world = true;            ///< at the last syncWithWorld
    bool warned = false;             ///< an event has said what the asset warns of, or would have
    bool told_shape = false;         ///< an event has said that its shape was changed; `told_mass` its mass
    bool told_mass = false;
    bool prepared_free = false;     ///< its asset was, but not as the body is held
    bool told_unbreakable = false;  ///< an event has said why nothing breaks it
    BodyToken token = no_token;     ///< tells `body` from a new one at its address
    int generation = 0;             ///< how many breaks in this world made it
    double least_energy_j = 0;      ///< with less, no blow breaks it, nor has an event; 0: not known
    InnerBall inner_ball;           ///< tells its side of ground
    GroundWay way;
    /// How long a fragment has been near a place.
    struct Stay {
        btTransform at = btTransform::getIdentity();
        double time_s = 0;
    };
    Stay settled, rocking, turning;
    double sunk_s = 0;        ///< how long a fragment has been deep in what does not give way
    bool just_added = false;  ///< by the app: no step has seen it
    bool being_born = false;  ///< a fragment that is about to enter the world

    bool ownedHere() const { return owned.body != nullptr; }
    bool isFragment() const { return generation > 0; }
    /// Places that it gives back to its fragments, of those that Budget::fragments_alive has.
    int ownPlaces() const { return isFragment() ? 1 : 0; }
    /// The map from the asset's frame to the world, for a body that stands at `world_transform`.
    btTransform placed(const btTransform& world_transform) const { return world_transform * body_from_asset; }
    /// An app may make a body static at any time.
    bool isDynamic() const { return !body->isStaticOrKinematicObject() && body->getInvMass() > 0; }
    /// Whether blows count: of bodies that move, and of static ones that are held on parts of their surface.
    bool canBeStruck() const {
        return isDynamic() || (asset.solid()->isAnchored() && !body->isKinematicObject());
    }
    /// Whether supports hold it.
    bool isHeld() const { return !isDynamic() && canBeStruck(); }
    /// Whether it is a fragment that supports of the whole still hold.
    bool isHeldRest() const { return isFragment() && isHeld(); }
    /// Whether it may break at that simulated time: neither debris nor just born.
    bool breaksAt(double time_s) const;
    /// Of what blow upwards there is anything to say: sets `least_energy_j`.
    void noteLeastEnergy();
    /// Whether it is large enough for that, and not of the last generation that may be.
    bool mayBreak() const { return breaksAt(std::numeric_limits<double>::infinity()); }
};

/// What a body is to break by that is the first of its line: the smallest fragment is filled in where it is
/// left open.
std::shared_ptr<const FractureSettings> fractureSettingsFor(const BreakableAsset& asset,
                                                            FractureSettings fracture);

/// The breakable bodies of one world, in the order in which they became breakable.
class BreakableRegistry {
  public:
    /// The body can be given a token.
    Breakable& add(std::unique_ptr<Breakable> breakable);
    /// `object` is alive, or was never an app's body that is breakable.
    Breakable* find(const btCollisionObject* object) const;
    /// The same of what is alive for sure, sooner.
    Breakable* of(const btCollisionObject& alive) const;
    bool isFragment(const btCollisionObject& alive) const {
        const Breakable* breakable = of(alive);
        return breakable && breakable->isFragment();
    }
    /// Removes and returns an entry; nullptr for other bodies.
    std::unique_ptr<Breakable> take(BodyToken token);
    /// Updates `in_world` of every entry. A body that the app removed from the world stays breakable, for
    /// when it comes back.
    void syncWithWorld(const btAlignedObjectArray<btCollisionObject*>& in_world);
    /// Drops the entries of the app's bodies that are dead for sure: another body is at their address. For
    /// between steps.
    void dropReplaced(const btAlignedObjectArray<btCollisionObject*>& in_world);

    const std::vector<std::unique_ptr<Breakable>>& all() const { return all_; }

    /// At the last syncWithWorld.
    bool anyInWorld() const { return any_in_world_; }
    bool anyFragmentInWorld() const { return any_fragment_in_world_; }
    /// Less than that breaks none of those in the world, J; infinite if there is none.
    double leastEnergyInWorld() const;

  private:
    /// What stood at a place in the world's array at the last syncWithWorld, dead or alive.
    struct Place {
        const btCollisionObject* object = nullptr;
        Breakable* breakable = nullptr;
    };

    /// The entry of what stands at a place in the world's array, which may be that of a dead body.
    Breakable* listed(const btCollisionObject* object, int place) const;

    std::vector<std::unique_ptr<Breakable>> all_;
    std::unordered_map<const btCollisionObject*, Breakable*>
        by_object_;              // for look-up only; never iterated over
    std::vector<Place> places_;  // most look-ups end here; empty after a change
    bool any_in_world_ = false, any_fragment_in_world_ = false;
};

}  // namespace sherd
