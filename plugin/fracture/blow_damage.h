#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/damage/damage.h"
#include "fracture/blow_stress.h"

namespace sherd {

/// What a blow damages, and which level of the stress says so.
struct BlowDamage {
    Level level = Level::full;
    BlowForces forces;
    Damage damage;  ///< empty if nothing strikes
    double residual_rel = 0;
    std::vector<std::string> warnings;
    /// For a contact that damages enough to break the body, but leaves it in one piece: adds what that
    /// damages as it rings. Empty where it is in `damage` already, or nothing rings. Refers to what
    /// `blowDamage` was given.
    std::function<void(BlowDamage& found)> add_ringing;
};

/// The factored stress problem of a solid. The first blow that needs it makes it, or waits for the thread
/// that does. Throws StageFailed if it cannot be made.
const StressSolver& solverOf(const BreakableSolid& solid, StageTimes& ms);

/// `strength` where full solves of the solid read the stress.
Strength strengthAtSamples(const BreakableSolid& solid, const BodyStrength& strength);

/// Asks the reduced model, if the solid has one and `fracture.use_reduced_model` allows it, else a full
/// solve; so, too, where the reduced model cannot answer, as under loads on most of the body. Throws
/// StageFailed with the sentence of a stage that fails.
BlowDamage blowDamage(const StrikeContext& struck, const Blow& blow, const BodyStrength& strength,
                      StageTimes& ms);

}  // namespace sherd
