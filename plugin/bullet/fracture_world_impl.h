#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <sherd/fracture_world.h>

#include <functional>
#include <optional>
#include <vector>

#include "bullet/bodies/app_requests.h"
#include "bullet/bodies/asset_store.h"
#include "bullet/bodies/breakable.h"
#include "bullet/bodies/kept_factors.h"
#include "bullet/fragments/birth_overlaps.h"
#include "bullet/fragments/continuous_collision.h"
#include "bullet/ground/moved_ground.h"
#include "bullet/ground/steady_contacts.h"
#include "bullet/island/island_state.h"
#include "bullet/schedule/foresight.h"
#include "bullet/schedule/patience.h"
#include "bullet/schedule/roles.h"
#include "bullet/schedule/solvers_ahead.h"
#include "bullet/schedule/waiting_blows.h"
#include "bullet/shapes/piece_contacts.h"
#include "bullet/shapes/shape_store.h"
#include "bullet/strikes/blow_log.h"
#include "bullet/strikes/contact_collector.h"
#include "bullet/strikes/recent_strikes.h"
#include "bullet/strikes/striker_contacts.h"
#include "bullet/world/impulse_write_back.h"
#include "bullet/world/solver_decorator.h"
#include "bullet/world/step_phase.h"
#include "core/numerics/parallel_chunks.h"
#include "core/numerics/stopwatch.h"
#include "fracture/blow_outcome.h"

namespace sherd {

/// The state of a FractureWorld and its part of a step: collect the contacts, evaluate the blows, swap broken
/// bodies for their fragments, solve the islands concerned once more.
class FractureWorld::Impl final : public StepListener, public IntegrationListener {
  public:
    explicit Impl(btDiscreteDynamicsWorld& world);
    ~Impl() override;
    /// Destroys it, inside a step at the end of that: until then Bullet goes on using the solver and the
    /// bodies.
    static void release(std::unique_ptr<Impl> impl);
    /// Ends a call of the app's: deletes what its callbacks released meanwhile, perhaps `impl` itself.
    static void deleteReleased(Impl& impl);

    // Called by the app.
    Result<btRigidBody*> add(const BreakableAsset& free_asset, const BodyOptions& options);
    Status makeBreakable(btRigidBody* body, const Material& material, const Settings& settings,
                         const BreakableOptions& options);
    void remove(btRigidBody* body);
    Status applyBlow(btRigidBody* body, const std::vector<Push>& pushes);
    Result<int> applyBlows(const std::vector<std::pair<btRigidBody*, std::vector<Push>>>& blows);
    /// Of the bodies in the world those that an explosion pushes, and how.
    std::vector<std::pair<btRigidBody*, std::vector<Push>>> pushesOnAll(
        const std::function<std::vector<Push>(const Breakable& body)>& pushes_on);
    void onFragment(FragmentCallback callback) {
        on_fragment_ = std::make_shared<const FragmentCallback>(std::move(callback));
    }
    std::vector<BlowEvent> takeEvents() { return log_.take(insideStep()); }
    Status setBudget(const Budget& budget);
    const Budget& budget() const { return budget_; }
    void setExecutor(Executor executor);
    std::vector<btRigidBody*> bodies();
    const BreakableRegistry& breakables() const { return breakables_; }
    BlowCounts counts() const;
    const WorldTimes& times() const { return times_; }

    // Inside a step.
    void beforeSolve() override;
    void afterSolve(const btContactSolverInfo& info, btIDebugDraw* drawer) override;
    void endSolve(const btContactSolverInfo& info) override;
    void bodiesEnter(const std::vector<btCollisionObject*>& bodies) override;
    void afterIntegration() override;
    void deleteIfReleased() override;

    // Asked by the other FractureWorlds of the world.
    bool isBreakable(const btCollisionObject& object) const override;
    bool isFragment(const btCollisionObject& object) const override;

  private:
    /// A body that broke, to be swapped for its fragments.
    struct Break {
        btRigidBody* body = nullptr;
        std::shared_ptr<const DecidedBlow> decided;
        std::size_t event = 0;         // of the step
        std::vector<Push> for_pieces;  // as in StruckBreakable
        std::uint64_t serial = 0;      // of the body
        StrikeOnWhole strike;
        std::optional<StruckBreakable> breaks_later = std::nullopt;  // its only fragment, by this
    };

    void prepareSolve();
    void endIntegration();
    GatedBlows gate(const std::vector<StruckBreakable>& struck, btScalar time_step_s);
    std::vector<Break> evaluateBlows(const std::vector<StruckBreakable>& struck, btScalar time_step_s);
    std::vector<std::shared_ptr<DecidedBlow>> decideNow(std::vector<std::shared_ptr<DecidedBlow>> blows);
    void lookAhead();
    void makeSolversFor(const btRigidBody& mover);
    /// Whether the app has not forbidden them.
    bool mayHaveThreads() const { return !executor_of_app_ || *executor_of_app_; }
    /// While one lives, its thread does alone what others may not help with.
    struct ThreadsAsAllowed {
        explicit ThreadsAsAllowed(const Impl& world) {
            if (!world.mayHaveThreads()) alone.emplace();
        }
        std::optional<OnThisThreadAlone> alone;
    };
    std::optional<ForeseenBlow> takeForeseen(const StruckBreakable& struck, const BlowToDecide& blow);
    void rehearse(const btRigidBody& mover, BodyToken token, const std::vector<Role>& roles);
    std::vector<ForeseenBlow> worthSolving(std::vector<StruckBreakable> struck, double strikes_at_s) const;
    bool mayBreakSoon(const StruckBreakable& struck, double strikes_at_s) const;
    ForeseenBlow asForeseen(const StruckBreakable& struck, double strikes_at_s) const;
    int placesAhead(const Breakable& body, int room) const;
    void findSolvedAhead(const std::vector<StruckBreakable>& struck, GatedBlows& gated);
    bool isOutdone(const StruckBreakable& struck) const;
    double energyOf(const StruckBreakable& struck) const;
    double hasteFor(const std::vector<const StruckBreakable*>& blows, btScalar time_step_s) const;
    void interruptWaiting(btScalar time_step_s);
    void letWait(std::vector<const StruckBreakable*> blows, int promised, btScalar time_step_s);
    std::optional<Break> tell(const StruckBreakable& struck, const BlowOutcome& outcome,
                              const std::shared_ptr<DecidedBlow>& decided);
    BlowToDecide toDecide(const StruckBreakable& struck, int most_fragments) const;
    void answerWaiting(btScalar time_step_s);
    int roomForFragments() const;
    int roomForPrepared() const;
    void dropWithoutRoom(const std::vector<StruckBreakable>& struck, GatedBlows& gated, int room);
    bool takeRoom(const StruckBreakable& struck, const BlowOutcome& outcome, int& room);
    StruckBreakable struckNow(Breakable& breakable, const WaitingBlow& blow) const;
    const Executor& executor();
    std::vector<StruckBreakable> struck(const btContactSolverInfo& info);
    bool anyWasHeld(const std::vector<Break>& breaks) const;
    bool wasDecided(const Breakable& breakable) const;
    void solveBreaks(const btContactSolverInfo& info, btIDebugDraw* drawer);
    std::vector<const Breakable*> bodiesInWorld() const;
    bool isFragmentOfAny(const btCollisionObject& object) const;
    SteadiedBodies steadiedBodies() const;
    void allowOverlapsAtBirth(const std::vector<btCollisionObject*>& new_bodies);
    void allowOverlapsOfAdded();
    std::vector<const btCollisionObject*> resolveIslands(std::vector<Break>& breaks,
                                                         const std::vector<btRigidBody*>& swept, bool last,
                                                         const btContactSolverInfo& info,
                                                         btIDebugDraw* drawer);
    Island restoredIsland(const std::vector<btCollisionObject*>& members);
    std::vector<const btCollisionObject*> sweepAgain(const std::vector<btRigidBody*>& swept, bool last,
                                                     btScalar time_step_s);
    std::vector<btCollisionObject*> swap(Break& broken, btScalar time_step_s);
    void breakLater(StruckBreakable rest, Breakable& piece, btScalar time_step_s);
    std::vector<Breakable*> registerFragments(const Breakable& parent,
                                              std::vector<std::unique_ptr<Breakable>> pieces,
                                              bool of_next_generation);
    std::uint64_t seedOf(const Breakable& breakable) const;
    std::vector<std::unique_ptr<Breakable>> makePieces(const Break& broken, const Breakable& parent,
                                                       bool inside_step);
    std::vector<btCollisionObject*> exchange(Break& broken, Breakable& parent,
                                             std::vector<std::unique_ptr<Breakable>> pieces,
                                             btScalar time_step_s);
    void findNewContacts(const std::vector<btCollisionObject*>& new_bodies);
    /// Whether the end of a step has anything to do but for bodies that move.
    bool hasWork() const;
    void finish(btScalar time_step_s);
    void finishBetweenSteps();
    void removeRequested();
    void carryOut(const std::vector<AppRequests::Blow>& blows, btScalar time_step_s);
    void replaceBroken(std::vector<Break> breaks, btScalar time_step_s);
    Breakable* stillThere(const Break& broken) const;
    Status enqueueBlow(btRigidBody* body, const std::vector<Push>& pushes, int explosion);
    std::vector<std::pair<Breakable*, std::vector<Push>>> targetsOf(const AppRequests::Blow& blow) const;
    Breakable& registerBreakable(std::unique_ptr<Breakable> breakable);
    Status checkHook() const;
    void tellWhatCannotBreak();
    Result<btRigidBody*> putIntoWorld(std::unique_ptr<Breakable> breakable, const BodyOptions& options);
    Status refusal(btRigidBody* body) const;
    bool insideStep() const { return isInsideStep(world_); }
    bool isToBeRemoved(const Breakable& breakable) const;
    BodyToken tokenToRemove(const btRigidBody* body) const;
    void removeNow(const AppRequests::Removal& removal);

    btDiscreteDynamicsWorld& world_;
    PieceContacts piece_contacts_;
    BreakableRegistry breakables_;
    ShapeStore shapes_;
    AssetStore assets_;
    BirthOverlaps birth_overlaps_;
    RecentStrikes recent_strikes_;
    StepSnapshot before_;
    MovedGround moved_ground_;
    ImpulseWriteBack write_back_;
    SweepExceptions sweep_exceptions_;
    bool awake_ = false;           // something in the world moves; set before each solve
    bool any_just_added_ = false;  // whether some body has been in no step yet
    bool any_breakable_ = false;   // something may break in the step
    double time_s_ = 0;            // simulated since the hook was set
    std::uint64_t next_serial_ = 0;
    BlowCounts counts_;
    WorldTimes times_;
    BlowLog log_{counts_, times_};
    Budget budget_;
    std::optional<Executor> executor_of_app_;  // none yet: threads of our own
    WaitingBlows waiting_;
    Foresight foresight_;
    SolversAhead solvers_ahead_;
    KeptFactors kept_factors_;
    Executor workers_ = nullptr;  // made when there is work for them; they end before what is made ahead
    StepSpent spent_;
    Patience patience_{budget_, breakables_, [this](const auto& object) { return isFragmentOfAny(object); }};
    Stopwatch solve_watch_;  // of Bullet's own solve
    std::shared_ptr<const FragmentCallback> on_fragment_ = std::make_shared<const FragmentCallback>();
    AppRequests requests_;
    bool released_ = false;     // inside a step: to be destroyed at its end
    bool integrating_ = false;  // the step's positions are not integrated yet
    bool world_calls_actions_ = true;
    // Removed bodies stay alive until the next solve: contacts of the current step may still point to them.
    std::vector<std::unique_ptr<Breakable>> to_delete_;
    SolverDecorator decorator_;
    IntegrationHook integration_hook_;
};

}  // namespace sherd
