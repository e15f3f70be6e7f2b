#pragma once

#include <sherd/times.h>

#include <optional>
#include <string>
#include <vector>

namespace sherd {

/// What a blow did to the struck body.
enum class Outcome {
    broke,  ///< the body was removed from the world, and its fragments stand in its place
    /// The body stays whole: nothing failed, the energy pays for no crack, or no piece came loose. In the
    /// last case what failed stays damaged: when a later blow damages more, cracks run through all of it.
    held,
    failed,  ///< the blow could not be worked out; the body stays whole, and `message` says why
    /// The budget (Budget) left no room for the blow: it was not decided, and the body stays whole.
    dropped,
};

/// What decided a blow: the first of these, from the gate on, that could.
enum class Level {
    none,  ///< nothing did: Outcome::dropped, or Outcome::failed before the blow was looked at
    /// The energy of the blow: it is too weak to break the body, or it tears what supports hold of one out of
    /// them (FractureSettings::same_blow_s). Or its contacts press nothing. Nothing was solved.
    gate,
    coarse,   ///< a solve of a fragment on a coarse grid: what it stores pays for no crack by far
    reduced,  ///< the reduced model of the stress that the asset keeps
    full,     ///< a full solve of the stress
};

/// The figures of one blow. SI units.
struct BlowFigures {
    Outcome outcome = Outcome::held;
    Level level = Level::none;
    /// Sum of the normal impulses of all contacts; of the pulse below where there are none, since something
    /// else stopped the striker in the step.
    double impulse_n_s = 0;
    /// Of the contact, as a pulse of half a sine with an impulse of 2 / pi times the two. The contact is
    /// elastic here, so that this is up to twice what moves the body: for loudness, not for momentum.
    double peak_force_n = 0;
    double contact_time_s = 0;  ///< duration of that pulse
    /// Largest principal stress at any particle or surface point of the body as if it held: where it breaks
    /// that may be many times its strength. 0 if nothing is under tension, and where the gate or a coarse
    /// solve decided.
    double largest_stress_pa = 0;
    /// Of the cracks that broke the body, one side, those around dropped debris included; 0 where it held.
    double crack_area_m2 = 0;
    double mass_error_rel = 0;    ///< of all fragments together, relative to the body
    double volume_error_rel = 0;  ///< the same of the volume
    double residual_rel = 0;      ///< of the linear solve
    /// How long the blow waited until it was decided, s of simulated time: Budget says which blows wait.
    double waited_s = 0;
    StageTimes ms;
    /// What a full solve says of a blow that another level decided, and its largest stress: only with
    /// FractureSettings::check_with_full_solve.
    std::optional<Outcome> full_solve_outcome;
    double full_solve_largest_stress_pa = 0;
    std::string message;  ///< failure and fallbacks, as sentences
    /// What limits trust in the stress, with the remedy. In a world the first blow on a body says also what
    /// its asset warns of (BreakableAsset::warnings), and one that is solved whether the program has changed
    /// the body's mass or shape since it was made breakable.
    std::vector<std::string> warnings;
};

/// Counts since the FractureWorld was made.
struct BlowCounts {
    /// Blows: a breakable body in contact in one step. A body is left out where all that touches it brings
    /// less energy than it takes to break it.
    long long seen = 0;
    // Of these, by what decided them: gate + coarse + reduced + full = seen.
    long long gate = 0, coarse = 0, reduced = 0, full = 0;
    // What the budget did with blows that the gate let through, beside those that were decided at once.
    long long waited = 0;   ///< decided later; they count as `seen` when they are
    long long merged = 0;   ///< on a body for which a harder one waited, or that broke before its turn came
    long long dropped = 0;  ///< never decided: Outcome::dropped
    /// Fell as foreseen (Budget::foresight_s): other threads were asked before. Whether they were done in
    /// time, `StepTimes::waiting` tells.
    long long foreseen = 0;
    /// Foreseen, but what fell was another blow, or none. They count nowhere else.
    long long foreseen_in_vain = 0;
    long long events_dropped = 0;  ///< since nobody took them, see FractureWorld::takeEvents

    long long solved() const { return reduced + full; }  ///< blows whose stress was solved

    /// Blows that a level decided; at Level::none those that are `dropped`.
    long long at(Level level) const {
        return level == Level::gate      ? gate
               : level == Level::coarse  ? coarse
               : level == Level::reduced ? reduced
               : level == Level::full    ? full
                                         : dropped;
    }
    long long& at(Level level) {
        return level == Level::gate      ? gate
               : level == Level::coarse  ? coarse
               : level == Level::reduced ? reduced
               : level == Level::full    ? full
                                         : dropped;
    }
};

}  // namespace sherd
