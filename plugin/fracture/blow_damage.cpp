#include "fracture/blow_damage.h"

#include "core/mlpg/splines/contact_remainder.h"
#include "fracture/stage.h"

namespace sherd {

const StressSolver& solverOf(const BreakableSolid& solid, StageTimes& ms) {
    if (solid.isFactored()) return *valueOrFail(solid.stressSolver());
    const Stopwatch making;
    const StressSolver& solver = *valueOrFail(solid.stressSolver());
    addMaking(solver, making.milliseconds(), ms);
    return solver;
}

Strength strengthAtSamples(const BreakableSolid& solid, const BodyStrength& strength) {
    return {solid.failureCriterion(), solid.material(),
            strength.atSamples(*valueOrFail(solid.completeDiscretisation()))};
}

namespace {

/// False if the reduced model cannot answer.
bool askReducedModel(const StrikeContext& struck, const ReducedStress& reduced, const Blow& blow,
                     const BodyStrength& strength, StageTimes& ms, BlowDamage& found) {
    ReducedResponse response;
    ReducedModel::LocalSystem kept;
    const StressOfLoads solve = [&](const std::vector<PointForce>& loads,
                                    const ContactField&) -> Result<double> {
        const AddedTime time(ms.solve);
        Result<ReducedResponse> answer = reduced.model.respond(loads, kept);
        if (!answer) return Error{answer.error()};
        response = std::move(answer).value();
        return response.strain_energy_j;
    };
    Result<BlowForces> forces =
        blowForces(struck.solid, struck.fracture.contact, blow, solve, {struck.solid.spacing()}, ms);
    if (!forces) return false;
    found.level = Level::reduced;
    found.forces = std::move(forces).value();
    found.warnings = reduced.warnings;
    if (found.forces.strike.empty()) return true;
    if (!found.forces.contact.near.empty()) {
        const AddedTime time(ms.solve);
        const auto remainder =
            contactRemainder(reduced.model.problem(), reduced.reading.points(), found.forces.contact);
        if (!remainder) return false;
        Result<ReducedResponse> rest = reduced.model.respond(remainder.value(), kept);
        if (!rest) return false;
        response = std::move(rest).value();
    }
    const AddedTime time(ms.damage);
    const BreakableSolid& solid = struck.solid;
    found.damage = reduced.reading.damage(
        response.unknowns, found.forces.contact, found.forces.pulse.peak_force_n,
        {solid.failureCriterion(), solid.material(), strength.atPoints(reduced.reading)});
    return true;
}

void solveFully(const StrikeContext& struck, const Blow& blow, const BodyStrength& strength, StageTimes& ms,
                BlowDamage& found) {
    BlowStress stress = valueOrFail(blowStress(struck, solverOf(struck.solid, ms), blow, ms));
    found.level = Level::full;
    found.residual_rel = stress.unit.residual_rel;
    found.warnings = stress.unit.warnings;
    if (!stress.strike.empty()) {
        const AddedTime time(ms.damage);
        found.damage = damagedParticles(stress.unit, stress.pulse.peak_force_n,
                                        *valueOrFail(struck.solid.completeDiscretisation()),
                                        strengthAtSamples(struck.solid, strength), {}, stress.places);
    }
    found.forces = std::move(stress);
}

}  // namespace

BlowDamage blowDamage(const StrikeContext& struck, const Blow& blow, const BodyStrength& strength,
                      StageTimes& ms) {
    BlowDamage found;
    const ReducedStress* reduced = struck.fracture.use_reduced_model ? struck.solid.reducedStress() : nullptr;
    if (!reduced || !askReducedModel(struck, *reduced, blow, strength, ms, found))
        solveFully(struck, blow, strength, ms, found);
    return found;
}

}  // namespace sherd
