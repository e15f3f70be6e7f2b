#include "fracture/damage_over_time.h"

#include <algorithm>
#include <utility>

namespace sherd {

namespace {

void include(Damage more, Damage& sum) {
    if (sum.damaged.empty()) {
        sum = std::move(more);
        return;
    }
    sum.count = 0;
    for (std::size_t i = 0; i < sum.damaged.size(); ++i) {
        sum.damaged[i] = sum.damaged[i] || more.damaged[i];
        sum.count += sum.damaged[i];
        if (more.overstress[i] <= sum.overstress[i]) continue;
        sum.overstress[i] = more.overstress[i];
        sum.stress[i] = more.stress[i];
    }
    sum.largest_stress_pa = std::max(sum.largest_stress_pa, more.largest_stress_pa);
}

}  // namespace

Damage damageOverTime(BlowForces& forces, double crack_j, const DamageAt& damage_at) {
    if (forces.pressed.empty()) return damage_at({0, forces.pulse.peak_force_n, {}, forces.strain_energy_j});
    Damage pressed, ringing;
    for (const VibrationState& state : forces.pressed) include(damage_at(state), pressed);
    double energy = 0;
    for (const VibrationState& state : forces.ringing) {
        include(damage_at(state), ringing);
        energy = std::max(energy, state.energy_j);
    }
    const bool breaks = pressed.count > 0 && forces.strain_energy_j >= crack_j;
    if (breaks) forces.crack_time_s = forces.pulse.duration_s;
    if (ringing.damaged.empty()) return pressed;
    if (breaks) {
        pressed.largest_stress_pa = std::max(pressed.largest_stress_pa, ringing.largest_stress_pa);
        return pressed;
    }
    include(std::move(ringing), pressed);
    forces.strain_energy_j = std::max(forces.strain_energy_j, energy);
    return pressed;
}

}  // namespace sherd
