#include "fracture/damage_waves.h"

#include <algorithm>

#include "core/numerics/stopwatch.h"
#include "fracture/blow_damage.h"
#include "fracture/stage.h"

namespace sherd {

namespace {

/// Damaged particles are free of stress in the next wave; how far they were over their strength still counts.
void keepLargest(const Damage& before, Damage& damage) {
    for (std::size_t i = 0; i < damage.overstress.size(); ++i) {
        if (!(before.overstress[i] > damage.overstress[i])) continue;
        damage.overstress[i] = before.overstress[i];
        damage.stress[i] = before.stress[i];
    }
    damage.largest_stress_pa = std::max(damage.largest_stress_pa, before.largest_stress_pa);
}

}  // namespace

Result<Damage> furtherWaves(const StrikeContext& struck, const std::vector<PointForce>& unit_loads,
                            double peak_force_n, Damage damage, StageTimes& ms) {
    for (int wave = 1; wave < struck.fracture.damage_waves; ++wave) {
        const Stopwatch making;
        const auto solver = struck.solid.stressSolverWithout(damage.damaged);
        if (!solver) return Error{solver.error()};
        addMaking(solver.value(), making.milliseconds(), ms);
        const auto stress = unitStress(struck, solver.value(), unit_loads, ms);
        if (!stress) return Error{stress.error()};

        const Stopwatch watch;
        Damage further = damagedParticles(
            stress.value(), peak_force_n, *valueOrFail(struck.solid.completeDiscretisation()),
            strengthAtSamples(struck.solid, struck.solid.strength()), damage.damaged);
        keepLargest(damage, further);
        const bool at_rest = further.count == damage.count;
        damage = std::move(further);
        ms.damage += watch.milliseconds();
        if (at_rest) break;
    }
    return damage;
}

}  // namespace sherd
