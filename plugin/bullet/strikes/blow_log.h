#pragma once

#include <sherd/events.h>
#include <sherd/times.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bullet/bodies/decided_blow.h"
#include "bullet/bodies/event_queue.h"
#include "bullet/strikes/contact_collector.h"

namespace sherd {

/// What came of blows, for the app: the events of the current step, and those before it that the app has not
/// taken yet. Counts them, and adds up what they took.
class BlowLog {
  public:
    BlowLog(BlowCounts& counts, WorldTimes& times) : counts_(counts), times_(times) {}

    /// Returns the number of the event in the step; none where the gate has decided the blow and there is
    /// nothing to say.
    std::optional<std::size_t> add(const StruckBreakable& struck, const BlowOutcome& outcome,
                                   const DecidedBlow* decided);
    /// A blow that the budget leaves undecided, or whose body it leaves whole.
    void addDropped(const StruckBreakable& struck, double impulse_n_s, const char* why, double waited_s = 0);
    /// The same, since `Budget::fragments_alive` has no place for the fragments.
    void addTooMany(const StruckBreakable& struck, double impulse_n_s, double waited_s = 0);
    /// A body that no blow can break as things are.
    void addUnbreakable(const Breakable& breakable, const std::string& why);

    /// The events of the step, in the order in which they were added.
    std::vector<QueuedEvent>& ofStep() { return of_step_; }
    const std::vector<QueuedEvent>& ofStep() const { return of_step_; }
    /// Ends the step: its events are the app's to take.
    void endStep();

    std::vector<BlowEvent> take(bool inside_step) { return queue_.take(inside_step); }
    bool hasReleased() const { return queue_.hasReleased(); }
    void deleteReleased() { queue_.deleteReleased(); }
    /// Events that were left out since the app took none for too long.
    long long leftOut() const { return queue_.dropped(); }

  private:
    BlowCounts& counts_;
    WorldTimes& times_;
    std::vector<QueuedEvent> of_step_;
    EventQueue queue_;
};

}  // namespace sherd
