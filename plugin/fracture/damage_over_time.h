#pragma once

#include <functional>

#include "core/damage/damage.h"
#include "fracture/blow_stress.h"

namespace sherd {

/// Adds the damage of the stress at a moment of a blow to that of others. `modes` of the state are empty
/// where the body follows the force statically.
using AddDamageAt = std::function<void(const VibrationState&, Damage& sum)>;

/// The damage of a blow at its hardest moments, all together, and the largest stress of these. What rings
/// after the contact counts only if the contact itself breaks nothing: then it is a whole body that rings.
/// To break it takes `crack_j`, and `forces.strain_energy_j` becomes that of the moments that count.
/// `forces.crack_time_s` is set if it is the contact that breaks the body.
Damage damageOverTime(BlowForces& forces, double crack_j, const AddDamageAt& add_damage_at);

}  // namespace sherd
