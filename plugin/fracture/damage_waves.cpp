#include "fracture/damage_waves.h"

#include "core/numerics/stopwatch.h"
#include "fracture/blow_damage.h"
#include "fracture/stage.h"

namespace sherd {

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
        // What is damaged is free of stress in the next wave; how far it was over its strength still counts.
        addDamage(damage, further);
        const bool at_rest = further.count == damage.count;
        damage = std::move(further);
        ms.damage += watch.milliseconds();
        if (at_rest) break;
    }
    return damage;
}

}  // namespace sherd
