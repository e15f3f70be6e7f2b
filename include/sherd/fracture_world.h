#pragma once

#include <LinearMath/btTransform.h>
#include <sherd/body_options.h>
#include <sherd/breakable_asset.h>
#include <sherd/budget.h>
#include <sherd/events.h>
#include <sherd/executor.h>
#include <sherd/fragment_birth.h>
#include <sherd/push.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#ifdef BT_USE_DOUBLE_PRECISION
#error "Sherd works with Bullet in single precision only: do not define BT_USE_DOUBLE_PRECISION"
#endif

class btDiscreteDynamicsWorld;
class btRigidBody;

namespace sherd {

class FractureWorld;
struct Explosion;
Result<int> explode(FractureWorld& world, const Explosion& explosion);

/// Makes bodies of a Bullet world breakable. Puts itself around the world's constraint solver when made; the
/// world must outlive it. Breaks happen inside `stepSimulation`, `applyBlow` and `explode`. Fragments inherit
/// nearly all that the broken body had; fragment_birth.h has the list. The destructor removes and deletes the
/// bodies that belong to this object, fragments included, removes the joints that hold them (the app goes on
/// owning these), and takes Sherd out of the world.
///
/// Set the world's constraint solver first: a solver that is set later replaces Sherd's, and nothing breaks
/// any more. `add` and `makeBreakable` then say so (`applyBlow` works still), as they do in a
/// btDeformableMultiBodyDynamicsWorld, in which nothing can break.
///
/// Threads. A FractureWorld belongs to the thread that steps its world: make every call from there, or while
/// no other thread steps or calls. Several worlds may be stepped on several threads, also with bodies of one
/// asset. Assets and stress models belong to no thread: `BreakableAsset::fromObj`, `fromMesh`, `prepare` and
/// all their other members may be called on any thread while worlds are stepped. An event that was taken is a
/// value and may go to any thread; what its pointers lead to stays with the stepping thread. The functions of
/// the settings (strength field, guide) are called in blows, on the thread that steps, also in those that
/// wait: with several worlds perhaps on several threads at once.
///
/// Inside a step, that is from a callback of Bullet's between the start of its collision detection and the
/// end of its solver, and inside a FragmentCallback: `add` and `makeBreakable` are refused, `remove` and
/// `applyBlow` wait for the end of the step, `takeEvents` gives the events of earlier steps, everything else
/// works as always; `stepSimulation` must not be called (from a FragmentCallback it throws std::logic_error,
/// which becomes a sentence of the event, and gravity acts once more in the step under way). A body that is
/// removed while it breaks is removed with all its fragments. Bullet's tick callbacks and actions are
/// outside. A callback that throws out of `stepSimulation` leaves the world inside the step, until the next
/// one is complete; a FractureWorld that is destroyed before leaves its bodies and its solver in the world
/// until then, or until that is destroyed.
///
/// Bullet does not tell that it is busy elsewhere. From callbacks of what the app calls itself
/// (`performDiscreteCollisionDetection`, `contactTest`, `rayTest`, `convexSweepTest`, `debugDrawWorld`) only
/// ask: a call that adds, removes or strikes a body, or destroys the FractureWorld, changes the lists that
/// Bullet is walking through, and crashes as Bullet's own `removeRigidBody` does there. Note what is wanted,
/// and do it afterwards. For the same reason, do not make the first FractureWorld of a world inside a step.
///
/// A world may have several FractureWorlds; each breaks the bodies that were made breakable with it.
class FractureWorld {
  public:
    /// Throws std::invalid_argument without a world.
    explicit FractureWorld(btDiscreteDynamicsWorld* world);
    ~FractureWorld();
    FractureWorld(const FractureWorld&) = delete;
    FractureWorld& operator=(const FractureWorld&) = delete;

    /// Adds a body to the world: a btRigidBody with the shape that its settings ask for (a btCompoundShape,
    /// or a btConvexHullShape or btBoxShape where that is enough), owned by this object, and valid until it
    /// is removed or breaks (BlowEvent::body). Bodies of one asset that ask for the same shape share it. The
    /// asset is sampled here unless `prepare` was called. The error says what is wrong with the options, why
    /// the asset's solid cannot be sampled, or that the world is inside a step. The app may take the body out
    /// of this world and put it back, but not into another world. Its extension pointer
    /// (internalSetExtensionPointer) is Sherd's.
    Result<btRigidBody*> add(const BreakableAsset& asset, const BodyOptions& options = {});

    /// Makes a body of the app's, with a compound of convex children (or one convex shape), breakable. It has
    /// to be in this world, and dynamic, or static with supports. Its mass stays what it is, and the density
    /// follows from that, not from the material; a static body has none, and there the material counts. The
    /// app goes on owning it; when it breaks it is removed from the world. Remove it from the world before
    /// you delete it. It is not prepared, so its first blow takes from tenths of a second, of which the step
    /// is spared what threads have done by then (Budget::foresight_s): call `asset(body)->prepareOnThread()`
    /// while the level loads and keep its future, once for all bodies that are alike: they share one asset.
    /// The error says what is wrong with the body, the material or the settings.
    Status makeBreakable(btRigidBody* body, const Material& material, const Settings& settings = {},
                         const BreakableOptions& options = {});

    /// Takes a body that was made here (or a fragment) out of the world and deletes it. A body of the app's
    /// stays in the world, and is not breakable any more. Other bodies are left alone.
    void remove(btRigidBody* body);

    /// Strikes a breakable body of the world as a bullet, a blast or a hammer of the program's own would: the
    /// same stress, strength, fragments and event as with a contact, and the impulse moves the body, or its
    /// fragments as one. Of a body with supports these are the fragments that come loose, which become no
    /// faster than the push (`Push::speed_m_s`, or the speed that it would give the body as a free mass); the
    /// rest, and what falls on a fragment that stays held, goes to what holds it. Outside a step the body
    /// breaks before this returns; whether it broke or held, its event says (`takeEvents`), and there is none
    /// if the push is far too weak. Bodies that still rest from their birth
    /// (FractureSettings::rest_after_break_s), and debris, are pushed only. The error says which figure is
    /// out of range, or why the body cannot be struck.
    Status applyBlow(btRigidBody* body, const Push& push);

    /// The same with several pushes that act together.
    Status applyBlow(btRigidBody* body, const std::vector<Push>& pushes);

    /// Has every new fragment shown to the app; an empty function ends that. Counts from the next fragment
    /// on, also when it is called from a FragmentCallback.
    void onFragment(FragmentCallback callback);

    /// Takes the blows that were solved since the last call (BlowEvent says which others), in order. Events
    /// wait to be taken, up to 1000 of them, and with them the bodies that broke. Of more, those of blows
    /// that the budget dropped are left out, then the oldest that held, then the oldest; and counted in
    /// `BlowCounts::events_dropped`.
    std::vector<BlowEvent> takeEvents();

    /// What breaking may cost a step, from the next blow on. The error says which field is out of range.
    Status setBudget(const Budget& budget);
    const Budget& budget() const;

    /// Who works on blows beside the thread that steps; an empty one: nobody, and no thread is made. By
    /// default it is as many threads as `workerThreads()` has, made when there is work for them; unlike those
    /// they leave their cores to what a step waits for. They run Bullet's allocator, too: an app that sets
    /// one of its own gives one that serves several threads.
    void setExecutor(Executor executor);

    BlowCounts counts() const;

    /// Wall-clock times. Called inside a step, those of earlier steps and of the stages that are done.
    WorldTimes times() const;

    /// The bodies made or made breakable here that are in the world now, fragments included, also those that
    /// never break (Debris::unbreakable), in the order in which they came.
    std::vector<btRigidBody*> bodies() const;

    /// The asset of a breakable body (fragments have one of their own), for its surface; valid for as long as
    /// the body is breakable. nullptr for other bodies, and for one that broke: its event has the asset.
    const BreakableAsset* asset(const btRigidBody* body) const;

    /// The name that a breakable body was given or inherited; empty for other bodies.
    std::string name(const btRigidBody* body) const;

    /// How many breaks made a body: 0 for one that was added, 1 for its fragments, and so on; 0 for other
    /// bodies.
    int generation(const btRigidBody* body) const;

    /// Maps the coordinates of `asset(body)->surface()` to the world, where the body stands after the last
    /// step (getWorldTransform, not interpolated). The identity for other bodies.
    btTransform assetTransform(const btRigidBody* body) const;

    /// The same where the body is to be drawn, by its motion state: Bullet moves that smoothly between steps.
    btTransform renderTransform(const btRigidBody* body) const;

  private:
    friend Result<int> explode(FractureWorld& world, const Explosion& explosion);
    Result<int> applyBlows(const std::vector<std::pair<btRigidBody*, std::vector<Push>>>& blows);

    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace sherd
