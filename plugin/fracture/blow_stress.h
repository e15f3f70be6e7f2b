#pragma once

#include <sherd/outcome.h>
#include <sherd/result.h>
#include <sherd/stress_field.h>

#include <functional>
#include <limits>
#include <vector>

#include "core/loads/blow.h"
#include "core/loads/contact_field.h"
#include "core/mlpg/stress_solver.h"
#include "core/vibration/modal_impact.h"
#include "fracture/strike_context.h"

namespace sherd {

/// The forces of a blow when it presses hardest: `loads` times `pulse.peak_force_n`.
struct BlowForces {
    std::vector<PointForce> strike;  ///< what strikes, 1 N in total; empty: nothing does
    std::vector<PointForce> loads;   ///< that, and what the supports of the body answer to it
    ContactField contact;            ///< the same, with the near field of what strikes told apart
    ContactPulse pulse;
    /// At the peak, of vibrations with that of their motion; never more than the blow brings.
    double strain_energy_j = 0;

    /// How the body vibrates under `loads`, and its hardest moments, while something presses on it and after
    /// that. Empty if it follows the force statically, or nothing is known of its vibrations.
    StruckModes modes;
    std::vector<VibrationState> pressed, ringing;
    /// How long cracks have until the contact that drives them is over, s. Infinite where what is stored in
    /// the whole body drives them.
    double crack_time_s = std::numeric_limits<double>::infinity();
};

/// The stress of a blow when it presses hardest: `unit` times `pulse.peak_force_n`.
struct BlowStress : BlowForces {
    StressField unit;          ///< under `loads`
    std::vector<Vec3> places;  ///< of its `points`, m
};

/// What a body does under unit loads.
struct UnitResponse {
    double strain_energy_j = 0;
    StruckModes modes = {};  ///< empty: nothing is known of its vibrations
};

/// Solves a body's stress under unit loads in any way, and keeps it. `contact` has the near field of what
/// strikes, and no other loads yet; `contact_s`: how long what strikes presses at least.
using StressOfLoads = std::function<Result<UnitResponse>(const std::vector<PointForce>& unit_loads,
                                                         const ContactField& contact, double contact_s)>;

/// On what the forces of a blow are solved.
struct SolvingGrid {
    double spacing_m = 0;
    bool near_fields = true;  ///< whether the near field of what strikes is looked for
};

/// What the loads need to know of a solid that a blow falls on. Refers to the solid.
ContactBody struckBody(const BreakableSolid& solid, const Blow& blow);

/// Whether a solid is anchored or rests on something, so that it may not give way to a blow.
bool isHeld(const BreakableSolid& solid, const Blow& blow);

/// Energy that a blow brings to a solid at most, J, by its strike.
double broughtEnergy(const BreakableSolid& solid, const Blow& blow, const Strike& strike);

/// Stress under loads of 1 N in total, with free surfaces free of traction. Adds the times to `ms`.
Result<StressField> unitStress(const StrikeContext& struck, const StressSolver& solver,
                               const std::vector<PointForce>& unit_loads, StageTimes& ms);

/// The forces of a blow, and the pulse that body and contact make of it together. Without supports that takes
/// one solve: what the body stores under a unit force decides how the energy is shared, and so the peak force
/// and the duration. Where the body's vibrations are known, it is the impact on these that does. Supports
/// answer the more the longer the pulse is, and lengthen it themselves, so the solve is repeated until their
/// answer stays. Weight is left out: the body bears it before and after the blow as well. What a grid coarser
/// than the solid's own does not see of the dents below the strike is added (patchEnergy). The last loads
/// that `solve` is given are those that are returned.
Result<BlowForces> blowForces(const BreakableSolid& solid, const ContactSettings& contact, const Blow& blow,
                              const StressOfLoads& solve, const SolvingGrid& grid, StageTimes& ms);

/// The same with the stress of a full solve. What nothing presses on is not factored.
Result<BlowStress> blowStress(const StrikeContext& struck, const Blow& blow, StageTimes& ms);

/// The stress at a moment of a blow whose vibrations are known to `model`, Pa.
Result<StressField> stressAt(const BlowStress& stress, const VibrationState& state,
                             const StressSolver& solver, const ReducedModel& model);

}  // namespace sherd
