#include "fracture/blow_stress.h"

#include <cmath>

#include "core/loads/support_answer.h"
#include "core/stress/elasticity.h"
#include "core/stress/surface_traction.h"

namespace sherd {

namespace {

constexpr int most_solves = 4;         // of one blow
constexpr double same_answer = 0.005;  // of the strike: a change of the answer that changes nothing

std::vector<PointForce> together(std::vector<PointForce> forces, const std::vector<PointForce>& more) {
    forces.insert(forces.end(), more.begin(), more.end());
    return forces;
}

}  // namespace

ContactBody struckBody(const BreakableSolid& solid) {
    return {solid.surfaceTree(), solid.material(),
            Mobility::of(solid.moments(), solid.material().density_kg_m3), solid.wallThickness(),
            solid.boundingRadius()};
}

bool isHeld(const BreakableSolid& solid, const Blow& blow) {
    return solid.isAnchored() || blow.isSupported();
}

double broughtEnergy(const BreakableSolid& solid, const Blow& blow, const ContactSettings& contact) {
    const auto strikes = strikesOf(struckBody(solid), blow, contact);
    return impactOf(strikes, isHeld(solid, blow) ? 1 : 0).energy();
}

Result<StressField> unitStress(const StrikeContext& struck, const StressSolver& solver,
                               const std::vector<PointForce>& unit_loads, StageTimes& ms) {
    Result<StressField> stress = solver.solve(unit_loads);
    if (!stress) return stress;
    freeSurface(struck.sampling, unit_loads, Elasticity(struck.solid.material()), stress.value().surface);
    ms.solve += stress.value().solve_ms;
    ms.stress += stress.value().recovery_ms;
    return stress;
}

Result<BlowStress> blowStress(const StrikeContext& struck, const StressSolver& solver, const Blow& blow,
                              StageTimes& ms) {
    const ContactSettings& contact = struck.fracture.contact;
    const ContactBody body = struckBody(struck.solid);
    const std::vector<Strike> strikes = strikesOf(body, blow, contact);
    BlowStress stress;
    stress.strike = stress.loads = unitLoads(body, strikes, contact);
    if (stress.strike.empty()) return stress;
    SupportAnswer answer;
    std::vector<Foundation> foundations;
    if (struck.solid.isAnchored())  // its supports are part of the stress problem
        answer.held = 1;
    else
        foundations = foundationsOf(body, blow, strikes, contact);

    for (int solve = 1; solve <= most_solves; ++solve) {
        Result<StressField> unit = unitStress(struck, solver, stress.loads, ms);
        if (!unit) return Error{unit.error()};
        stress.unit = std::move(unit).value();
        stress.pulse = contactPulse(impactOf(strikes, answer.held), stress.unit.strain_energy_j,
                                    contact.shortest_contact_s);
        if (foundations.empty()) break;
        SupportAnswer next = supportAnswer(body, foundations, stress.strike, stress.pulse.duration_s);
        if (std::abs(next.sum_n - answer.sum_n) < same_answer || solve == most_solves) break;
        answer = std::move(next);
        stress.loads = together(stress.strike, answer.forces);
    }
    stress.strain_energy_j =
        stress.unit.strain_energy_j * stress.pulse.peak_force_n * stress.pulse.peak_force_n;
    return stress;
}

}  // namespace sherd
