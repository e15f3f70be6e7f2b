#pragma once

#include <sherd/budget.h>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "bullet/bodies/breakable.h"
#include "bullet/strikes/contact_collector.h"
#include "fracture/blow_outcome.h"

namespace sherd {

constexpr int fewest_fragments = 2;  // of a break

/// Whole or broken, a body takes a few percent of the speed of what is so many times as heavy.
constexpr btScalar much_heavier = 50;

/// Whether a piece comes out of its supports whole, and whether it is to break after that.
enum class Torn : char { not_at_all, for_good, first };

/// Blows of one step, by their numbers.
struct GatedBlows {
    std::vector<std::optional<BlowOutcome>> held;  ///< all of them; empty where the gate does not say
    std::vector<StageTimes> ms;                    ///< all of them
    std::vector<std::size_t> now, later;           ///< what is to be decided, ascending
    std::vector<Torn> torn;                        ///< all of them
    std::vector<std::optional<int>> ahead;  ///< all of them: pieces, where it was solved before it fell
};

/// What a step has taken of its budget so far.
struct StepSpent {
    int decided = 0;           ///< blows
    double decided_ms = 0;     ///< what these are estimated to take
    double interrupted_s = 0;  ///< of the time of what waits
    int new_fragments = 0;
};

/// Says which blows of a step wait, as the budget has it.
class Patience {
  public:
    using IsFragment = std::function<bool(const btCollisionObject&)>;

    /// All of them outlive it. `is_fragment`: of any FractureWorld of the world.
    Patience(const Budget& budget, const BreakableRegistry& breakables, IsFragment is_fragment)
        : budget_(budget), breakables_(breakables), is_fragment_(std::move(is_fragment)) {}

    bool isMoreUrgent(const StruckBreakable& a, const StruckBreakable& b) const {
        return urgency(a) > urgency(b);
    }
    /// Whether the blow may be decided later: one on a fragment, unless a body that strikes it would be
    /// turned back by what is broken in truth.
    bool mayWait(const StruckBreakable& struck) const;
    /// Whether the blow on a whole body may be decided later: nothing flies through the body, it is struck by
    /// other breakable bodies, by what does not move, or by what is so many times as heavy.
    bool lastsWhileItWaits(const StruckBreakable& struck, btScalar times_as_heavy) const;

    /// Lets blows on whole bodies wait, the least urgent first, until the others take no longer than the
    /// budget has milliseconds: those that nothing flies through, where there is more to be decided in the
    /// step than it has solves, or where a ball breaks others, and those that fragments strike. Of the last,
    /// and of an explosion's, one is decided in any case if the step has no more. Of a crowd that something
    /// heavy runs into, as many are as the step has solves. What was solved before it fell takes none of the
    /// step's time, only places for its fragments: where these run out it waits, or is solved anew for fewer
    /// if it may not.
    void thinOut(const std::vector<StruckBreakable>& struck, double time_step_s, const StepSpent& spent,
                 GatedBlows& gated) const;
    /// Of the rests that supports hold, those that are more than the step has solves come out whole, and
    /// break later: what has broken the whole goes on into one after the other, and may not wait.
    void tearOutFirst(const std::vector<StruckBreakable>& struck, const StepSpent& spent,
                      GatedBlows& gated) const;

  private:
    /// The order in which blows get their room in a step.
    struct Turns {
        std::size_t first_that_may_wait, first_that_needs_time;
        bool is_crowd;
    };

    double urgency(const StruckBreakable& struck) const;
    bool isMovedAgainst(const StruckBreakable& struck) const;
    bool isRunInto(const StruckBreakable& struck) const;
    bool fallsOnHeavy(const StruckBreakable& struck) const;
    bool isBacked(const StruckBreakable& struck) const;
    bool isStruckByFragmentsAlone(const StruckBreakable& struck) const;
    bool isStruckByLightFragments(const StruckBreakable& struck) const;
    void fillStep(const std::vector<StruckBreakable>& struck, const Turns& turns, double most_ms,
                  const StepSpent& spent, GatedBlows& gated) const;

    const Budget& budget_;
    const BreakableRegistry& breakables_;
    IsFragment is_fragment_;
};

}  // namespace sherd
