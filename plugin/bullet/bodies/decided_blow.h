#pragma once

#include <sherd/executor.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "bullet/shapes/rigid_body_factory.h"
#include "core/loads/blow.h"
#include "core/numerics/job.h"
#include "fracture/blow_outcome.h"

namespace sherd {

/// A blow with all that decides it.
struct BlowToDecide {
    std::shared_ptr<const BreakableSolid> solid;
    Blow blow;
    std::shared_ptr<const FractureSettings> fracture;
    std::uint64_t seed = 0;
    std::shared_ptr<const DamagedMaterial> earlier;  ///< what is damaged of the body
    StageTimes before;                               ///< what was done of it already
};

/// Whether deciding a blow calls no function of the app's: those are called on the thread that steps.
bool mayRunElsewhere(const BreakableSolid& solid, const FractureSettings& fracture);

/// What comes of a blow, as a job that any thread may do.
class DecidedBlow {
  public:
    static std::shared_ptr<DecidedBlow> make(BlowToDecide blow);
    /// One that needs no deciding.
    static std::shared_ptr<DecidedBlow> decided(BlowOutcome outcome,
                                                std::vector<std::shared_ptr<const OwnedShape>> shapes);

    /// Has it done elsewhere, if it may be.
    void submit(const Executor& executor);
    bool isSubmitted() const { return submitted_; }
    /// Decides it here if no thread has begun.
    void decideIfFree() { job_->doIfFree(); }
    /// The same on any thread; not if it calls functions of the app's.
    void decideIfFreeAnywhere() {
        if (may_run_elsewhere_) job_->doIfFree();
    }
    void hurry() { job_->hurry(); }
    bool isDecided() const { return job_->isDone(); }
    /// Since a thread began with it, ms; 0: none has.
    double decidedFor_ms() const { return job_->begunFor_ms(); }
    /// Waits for a thread that is at it, for some milliseconds at most.
    void waitIfBegun(double most_ms) { job_->waitIfBegun(most_ms); }
    /// Returns when it is decided. Adds what it took to `waiting_ms` if another thread has done it.
    void finish(double& waiting_ms);

    bool is_foreseen = false;  ///< it was made before the blow fell

    // After `finish`.
    bool doneElsewhere() const { return !job_->doneHere(); }
    BlowOutcome outcome;
    /// What is to stand for each fragment in collisions.
    std::vector<std::shared_ptr<const OwnedShape>> shapes;

  private:
    DecidedBlow() = default;
    static void decide(const BlowToDecide& blow, DecidedBlow& decided);

    std::shared_ptr<Job> job_;
    bool may_run_elsewhere_ = false, submitted_ = false, finished_ = false;
};

}  // namespace sherd
