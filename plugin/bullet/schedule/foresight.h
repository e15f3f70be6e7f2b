#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "bullet/bodies/body_token.h"
#include "bullet/island/island_state.h"
#include "bullet/schedule/foreseen_blow.h"

class btDiscreteDynamicsWorld;
class btRigidBody;

namespace sherd {

/// What strikes what in the steps to come, and what comes of it. A body that flies freely does what a
/// rehearsal of a few steps says, so that its blow can be solved beside these steps instead of in the one in
/// which it falls. A blow that falls otherwise than foreseen is solved when it falls. All of this follows
/// from the state of the world alone, never from which thread was faster.
class Foresight {
  public:
    bool empty() const { return outlooks_.empty() && blows_.empty(); }
    /// Forgets all of it. Returns how many blows that were.
    int clear();

    /// For the end of a step: drops what has not come true. Returns how many blows that were.
    int follow(const btDiscreteDynamicsWorld& world, double time_s);
    /// What rehearsals may cost yet in this step, in steps of one body that touches nothing. A step of the
    /// world gives a fixed number of these, which add up for a while.
    int credit() const { return credit_; }
    /// Whether nothing is known of what a body does from here on, or too little of it to be worth more.
    bool isToBeLookedAt(BodyToken mover, double time_s, double ahead_s) const;
    /// Notes where a body goes, up to `until_s`, and what finding out cost. `is_too_dear`: nothing was found
    /// in a single step, and more would have cost too much; after a few of these it is left alone for a
    /// while.
    void note(BodyToken mover, std::vector<BodyState> way, double until_s, int cost, bool is_too_dear);
    /// Notes a blow that keeps one worker busy for `turn_s` of simulated time, after those noted before it.
    void note(ForeseenBlow blow, double turn_s);
    bool isForeseen(std::uint64_t serial) const;
    /// The blow that falls as it was foreseen; nullptr for others.
    const ForeseenBlow* find(const StruckBreakable& struck, const BlowToDecide& blow) const;
    /// Of the blows that are to be solved in full, how many are still to fall.
    int fullSolves() const;
    /// For the end of a step: waits a little for blows that other threads are at, or does some of those that
    /// none has begun, rather than all of it in the step in which they fall. In a program that steps as fast
    /// as it can, simulated time runs ahead of the other threads; one whose steps wait for real time has
    /// nothing to wait for here: nor have, of more than `most_solves`, those for which the budget has no time
    /// until they fall. What comes of the blows does not depend on it.
    void keepUp(double time_s, double time_step_s, int most_solves, double& waiting_ms) const;
    /// Does here what the one worker would have done by then: for worlds without an executor.
    void workUntil(double time_s) const;
    /// The blow that falls as it was foreseen, which is foreseen no longer; none for others.
    std::optional<ForeseenBlow> take(const StruckBreakable& struck, const BlowToDecide& blow, double time_s);

  private:
    /// What is known of a body.
    struct Outlook {
        BodyToken mover = no_token;
        std::vector<BodyState> way;  // at the end of each step since it was looked at; empty: it left it
        std::size_t steps = 0;       // gone since
        double until_s = 0;          // simulated time
        int surprises = 0;           // one after the other
        double rest_s = 0;           // how long it was last left alone, since nobody foresees what it does
        double rests_until_s = 0;
    };
    Outlook* of(BodyToken mover);
    static void surprised(Outlook& outlook, double time_s);
    /// Where a blow leaves the plan, the worker goes on with the next one at once.
    void leavePlan(const ForeseenBlow& blow, double time_s);
    /// Whether a body left the way that it was to go; forgets that.
    static bool strays(Outlook& outlook, const btRigidBody& body, double time_s);

    std::vector<Outlook> outlooks_;  // in the order in which they were noted
    std::vector<ForeseenBlow> blows_;
    double busy_until_s_ = 0;  // the one worker, simulated time
    int credit_ = 0;
};

}  // namespace sherd
