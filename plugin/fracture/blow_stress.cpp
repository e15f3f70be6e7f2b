#include "fracture/blow_stress.h"

#include "core/stress/elasticity.h"
#include "core/stress/surface_traction.h"

namespace sherd {

Result<StressField> unitStress(const StrikeContext& struck, const StressSolver& solver,
                               const std::vector<PointForce>& unit_loads, StageTimes& ms) {
    Result<StressField> stress = solver.solve(unit_loads);
    if (!stress) return stress;
    freeSurface(struck.sampling, unit_loads, Elasticity(struck.solid.material()), stress.value().surface);
    ms.solve += stress.value().solve_ms;
    ms.stress += stress.value().recovery_ms;
    return stress;
}

Result<BlowStress> blowStress(const StrikeContext& struck, const StressSolver& solver,
                              const ContactLoads& loads, StageTimes& ms) {
    Result<StressField> unit = unitStress(struck, solver, loads.unit, ms);
    if (!unit) return Error{unit.error()};
    const ContactSettings& contact = struck.fracture.contact;
    BlowStress stress;
    stress.unit = std::move(unit).value();
    stress.pulse = contactPulse(loads.hertz_force_n, stress.unit.strain_energy_j, loads.mass_kg,
                                loads.speed_m_s, contact.shortest_contact_s, contact.longest_contact_s);
    stress.strain_energy_j =
        stress.unit.strain_energy_j * stress.pulse.peak_force_n * stress.pulse.peak_force_n;
    return stress;
}

}  // namespace sherd
