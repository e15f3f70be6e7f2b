#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <sherd/fracture_world.h>

#include <string>
#include <vector>

#include "bullet/birth_overlaps.h"
#include "bullet/breakable.h"
#include "bullet/contact_collector.h"
#include "bullet/impulse_write_back.h"
#include "bullet/island_state.h"
#include "bullet/solver_decorator.h"
#include "fracture/pipeline.h"

namespace sherd {

/// The state of a FractureWorld and its part of a step: collect the contacts, evaluate the blows, swap broken
/// bodies for their fragments, solve the islands concerned once more.
class FractureWorld::Impl final : public StepListener {
  public:
    explicit Impl(btDiscreteDynamicsWorld& world);
    ~Impl() override;

    // Between steps.
    btRigidBody* add(const BreakableAsset& asset, const btTransform& start);
    Status makeBreakable(btRigidBody* body, const Material& material, const Settings& settings);
    void remove(btRigidBody* body);
    std::vector<BreakEvent> takeEvents();
    std::vector<btRigidBody*> bodies();
    const BreakableRegistry& breakables() const { return breakables_; }
    const BlowCounts& counts() const { return counts_; }
    const std::string& lastError() const { return last_error_; }

    // Inside a step.
    void beforeSolve() override;
    void afterSolve(const btContactSolverInfo& info, btIDebugDraw* drawer) override;

  private:
    /// A body that broke, to be swapped for its fragments.
    struct Break {
        btRigidBody* body = nullptr;
        BlowOutcome outcome;
        std::size_t event = 0;  // in events_
    };

    std::vector<Break> evaluateBlows(const std::vector<StruckBreakable>& struck);
    void allowOverlapsAtBirth(const std::vector<btCollisionObject*>& new_bodies);
    void resolveIslands(std::vector<Break>& breaks, const btContactSolverInfo& info, btIDebugDraw* drawer);
    std::vector<btCollisionObject*> swap(Break& broken, btScalar time_step_s);
    std::uint64_t seedOf(const Breakable& breakable) const;
    Breakable& registerBreakable(std::unique_ptr<Breakable> breakable);
    Status refusal(const btRigidBody* body) const;
    bool insideStep() const;
    void markStepDone();
    void removeNow(btRigidBody* body);

    btDiscreteDynamicsWorld& world_;
    BreakableRegistry breakables_;
    BirthOverlaps birth_overlaps_;
    StepSnapshot before_;
    ImpulseWriteBack write_back_;
    bool any_breakable_ = false;  // a breakable body is in the world; set before each solve
    double time_s_ = 0;           // simulated since the hook was set
    std::uint64_t next_serial_ = 0;
    std::vector<BreakEvent> events_;
    BlowCounts counts_;
    std::string last_error_;
    std::vector<btRigidBody*> to_remove_;  // requested inside a step, removed at its end
    // Broken bodies are removed from the world and kept alive until their event is taken; after that, and
    // after a removal, until the next solve, since contacts of the current step may still point to them.
    std::vector<std::unique_ptr<Breakable>> broken_;
    std::vector<std::unique_ptr<Breakable>> to_delete_;
    SolverDecorator decorator_;
};

}  // namespace sherd
