#pragma once

#include <sherd/budget.h>
#include <sherd/executor.h>
#include <sherd/push.h>

#include <cstdint>
#include <deque>
#include <limits>
#include <memory>
#include <vector>

#include "bullet/bodies/body_token.h"
#include "bullet/bodies/decided_blow.h"

namespace sherd {

/// A blow that is decided some time after it fell.
struct WaitingBlow {
    std::uint64_t serial = 0;  ///< of the body
    bool is_on_fragment = true;
    bool is_kept = false;  ///< never dropped
    int promised = 0;      ///< more bodies at most, for which there is room in the world if it is kept
    double impulse_n_s = 0;
    double work_ms = 0;   ///< what it is estimated to take
    double energy_j = 0;  ///< that it brings at most: of two, the one with more is the harder
    Vec3 position = Vec3::Zero(), normal = Vec3::Zero();  ///< as in StruckBreakable, but in the asset's frame
    const btCollisionObject* striker = nullptr;           ///< may be dead: compared with its token
    BodyToken striker_token = no_token;
    /// If it was foreseen, when the worker that solves what is foreseen is done with it; simulated time.
    double solved_by_s = std::numeric_limits<double>::infinity();
    double struck_at_s = 0, begun_s = 0, worked_by_s = 0, due_s = 0;  ///< simulated time
    std::shared_ptr<DecidedBlow> decided;
    std::vector<Push> for_pieces;  ///< as in StruckBreakable, in the asset's frame
};

/// What a blow on a solid takes about, ms of one core; of the solid's size and of how many contacts hold it
/// alone.
double estimatedMilliseconds(const BreakableSolid& solid, const Blow& blow);

/// What the first blow on a whole body takes beyond that, since nothing has been made ready for it: 0 where
/// something has, at any time of a thread's work.
double setUpMilliseconds(const BreakableSolid& solid);

/// Computing time that a budget has beside a step.
double millisecondsPerStep(const Budget& budget, double time_step_s);

/// The blows that wait, in the order of their turns. When it is a blow's turn follows from the estimates, as
/// if one worker did the blows one after the other: so it is the same on every machine. A whole body that
/// breaks long after it was struck is seen to, so those on whole bodies go before those on fragments.
class WaitingBlows {
  public:
    enum class Fate { waits, merged, dropped };

    bool empty() const { return blows_.empty(); }

    /// How long the one worker is busy with a blow that is estimated to take `work_ms` and fell in a step of
    /// `time_step_s`.
    static double turn_s(double work_ms, const Budget& budget, double time_step_s);
    /// How long the worker has for blows on whole bodies until the last moment to which one may wait, and
    /// half of that wait at least.
    double left_s(const Budget& budget, double time_s) const;
    /// Of two blows on a body the harder one waits, in the place of the other if that is not begun; the
    /// weaker one is merged. One that was foreseen has part of its turn behind it.
    Fate add(WaitingBlow blow, double turn_s, const Budget& budget, double time_s);
    /// The one worker is at something else for a while: what it is at, and what it has not begun, is done
    /// later, but waits no longer than the budget says.
    void interrupt(double for_s, const Budget& budget, double time_s);
    /// For another budget: none waits for longer than it says, nor any more where it lets none wait.
    void keepTo(const Budget& budget, double time_s);
    /// Has blows worked on whose turn comes next: those of bodies that have no earlier one.
    void submit(const Executor& executor, double time_s);
    /// Does here what the one worker would have done by then: for worlds without an executor.
    void workUntil(double time_s);
    /// The next blow, if it is its turn.
    const WaitingBlow* due(double time_s) const;
    /// Returns when the next blow is decided. While another thread is at it, this one takes those that are to
    /// be done by `until_s`, and others that take no longer than what is left of it.
    void finishFirst(double until_s, double& waiting_ms);
    WaitingBlow takeFirst();
    /// The blow that waits for the body and may not be dropped, since an explosion has struck; nullptr: none.
    const WaitingBlow* keptFor(std::uint64_t serial) const;
    /// What all blows on the body that wait have for its pieces, in the asset's frame.
    std::vector<Push> pushesFor(std::uint64_t serial) const;
    /// Fragments that bodies may become whose blows are kept.
    int promised() const;
    /// The blow that the body's next one has to wait for is decided when this returns: what a solid keeps of
    /// a blow must not depend on which thread was faster.
    void settle(std::uint64_t serial, double& waiting_ms);

  private:
    bool isFirstOfItsBody(std::size_t number) const;

    std::deque<WaitingBlow> blows_;
    double busy_until_s_ = 0;  ///< the one worker, simulated time
};

}  // namespace sherd
