#include "fracture/damage_over_time.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/numerics/parallel_chunks.h"

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

/// What all states damage together, each read on its own.
Damage damageOf(const std::vector<VibrationState>& states, const DamageAt& damage_at) {
    std::vector<Damage> each(states.size());
    forEachChunk(static_cast<int>(states.size()), [&](int i) { each[i] = damage_at(states[i]); });
    Damage sum;
    for (Damage& damage : each) include(std::move(damage), sum);
    return sum;
}

}  // namespace

Damage damageOverTime(BlowForces& forces, double crack_j, const DamageAt& damage_at) {
    if (forces.pressed.empty()) return damage_at({0, forces.pulse.peak_force_n, {}, forces.strain_energy_j});
    Damage found = damageOf(forces.pressed, damage_at);
    if (found.count > 0 && forces.strain_energy_j >= crack_j) {  // what would have rung is in pieces by then
        forces.crack_time_s = forces.pulse.duration_s;
        return found;
    }
    if (forces.ringing.empty()) return found;
    include(damageOf(forces.ringing, damage_at), found);
    for (const VibrationState& state : forces.ringing)
        forces.strain_energy_j = std::max(forces.strain_energy_j, state.energy_j);
    return found;
}

}  // namespace sherd
