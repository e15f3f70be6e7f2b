#pragma once

#include <string>
#include <vector>

namespace sherd {

/// What a blow did to the struck body.
enum class Outcome {
    broke,  ///< the body was removed from the world, and its fragments stand in its place
    /// The body stays whole: nothing failed, the energy pays for no crack, or no piece came loose.
    held,
    failed,  ///< the blow could not be worked out; the body stays whole, and `message` says why
};

/// Milliseconds of each stage of one blow; 0 where a stage was not needed.
struct StageTimes {
    double sample = 0, assemble = 0, factor = 0;  ///< of a first blow on a body
    double solve = 0, stress = 0;                 ///< the linear solve, and the stress of its solution
    double damage = 0, cluster = 0, surface = 0;  ///< from the stress to the surfaces of the fragments
    double bodies = 0;                            ///< making the rigid bodies
    double resolve_step = 0;                      ///< solving the step again with them, `bodies` not included
};

/// The figures of one blow whose stress was solved. SI units.
struct BlowFigures {
    Outcome outcome = Outcome::held;
    double impulse_n_s = 0;     ///< sum of the normal impulses of all contacts
    double peak_force_n = 0;    ///< of the contact, as a pulse of half a sine
    double contact_time_s = 0;  ///< duration of that pulse
    /// Largest principal stress at any particle or surface point; 0 if nothing is under tension.
    double largest_stress_pa = 0;
    double mass_error_rel = 0;    ///< of all fragments together, relative to the body
    double volume_error_rel = 0;  ///< the same of the volume
    double residual_rel = 0;      ///< of the linear solve
    StageTimes ms;
    std::string message;  ///< failure and fallbacks, as sentences
    /// What limits trust in the stress, with the remedy. In a world the first blow on a body says also what
    /// its asset warns of (BreakableAsset::warnings).
    std::vector<std::string> warnings;
};

}  // namespace sherd
