#pragma once

#include <functional>

#include "core/damage/damage.h"
#include "fracture/blow_stress.h"

namespace sherd {

/// Adds the damage of the stress at a moment of a blow to that of others. `modes` of the state are empty
/// where the body follows the force statically.
using AddDamageAt = std::function<void(const VibrationState&, Damage& sum)>;

/// The damage of a blow at its hardest moments while something presses, all together, and the largest stress
/// of these. Where vibrations are known, `forces.crack_time_s` becomes the time of the contact.
Damage damageOfContact(BlowForces& forces, const AddDamageAt& add_damage_at);

/// What rings after the contact counts only if the contact itself does not break the body: then it is a whole
/// body that rings. Adds its hardest moments; `forces.strain_energy_j` becomes that of all moments, and
/// `forces.crack_time_s` infinite.
void addRinging(BlowForces& forces, const AddDamageAt& add_damage_at, Damage& sum);

}  // namespace sherd
