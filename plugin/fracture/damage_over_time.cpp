#include "fracture/damage_over_time.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace sherd {

namespace {

/// What all states damage together, the hardest first: it leaves little to be read for the others.
void addAll(std::vector<VibrationState> states, const AddDamageAt& add_damage_at, Damage& sum) {
    std::stable_sort(states.begin(), states.end(), [](const VibrationState& a, const VibrationState& b) {
        return a.energy_j > b.energy_j;
    });
    for (const VibrationState& state : states) add_damage_at(state, sum);
}

}  // namespace

Damage damageOfContact(BlowForces& forces, const AddDamageAt& add_damage_at) {
    Damage found;
    if (forces.pressed.empty()) {
        add_damage_at({0, forces.pulse.peak_force_n, {}, forces.strain_energy_j}, found);
        return found;
    }
    addAll(forces.pressed, add_damage_at, found);
    forces.crack_time_s = forces.pulse.duration_s;
    return found;
}

void addRinging(BlowForces& forces, const AddDamageAt& add_damage_at, Damage& sum) {
    addAll(forces.ringing, add_damage_at, sum);
    for (const VibrationState& state : forces.ringing)
        forces.strain_energy_j = std::max(forces.strain_energy_j, state.energy_j);
    forces.crack_time_s = std::numeric_limits<double>::infinity();
}

}  // namespace sherd
