#include "fracture/damage_waves.h"

#include <algorithm>

#include "core/numerics/stopwatch.h"
#include "core/stress/elasticity.h"
#include "core/stress/surface_traction.h"

namespace sherd {

Result<Damage> furtherWaves(const BreakableSolid& body, const std::vector<PointForce>& unit_loads,
                            double peak_force_n, const Strength& strength, Damage damage, StageTimes& ms) {
    const auto solid = body.discretisation();
    if (!solid) return Error{solid.error()};
    for (int wave = 1; wave < body.settings().fracture.damage_waves; ++wave) {
        const auto solver = body.stressSolverWithout(damage.damaged);
        if (!solver) return Error{solver.error()};
        Result<StressField> stress = solver.value().solve(unit_loads);
        if (!stress) return Error{stress.error()};
        freeSurface(*solid.value(), unit_loads, Elasticity(body.material()), stress.value().surface);
        ms.assemble += solver.value().report().assemble_ms;
        ms.factor += solver.value().report().factor_ms;
        ms.solve += stress.value().solve_ms;
        ms.stress += stress.value().recovery_ms;

        const Stopwatch watch;
        Damage further =
            damagedParticles(stress.value(), peak_force_n, *solid.value(), strength, damage.damaged);
        // Damaged particles are free of stress by now; how far they were over their strength still counts.
        for (std::size_t i = 0; i < further.overstress.size(); ++i)
            further.overstress[i] = std::max(further.overstress[i], damage.overstress[i]);
        further.largest_stress_pa = std::max(further.largest_stress_pa, damage.largest_stress_pa);
        const bool at_rest = further.count == damage.count;
        damage = std::move(further);
        ms.damage += watch.milliseconds();
        if (at_rest) break;
    }
    return damage;
}

}  // namespace sherd
