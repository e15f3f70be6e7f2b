#include "fracture/blow_damage.h"

#include "core/mlpg/splines/contact_remainder.h"
#include "fracture/crack_energy.h"
#include "fracture/damage_over_time.h"
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

double crackEnergy(const StrikeContext& struck) {
    return smallestCrackEnergy(struck.solid, struck.fracture);
}

/// An error if the reduced model cannot answer.
Status askReducedModel(const StrikeContext& struck, const ReducedStress& reduced, const Blow& blow,
                       const BodyStrength& strength, StageTimes& ms, BlowDamage& found) {
    ReducedResponse response;
    ReducedModel::LocalSystem kept;
    const StressOfLoads solve = [&](const std::vector<PointForce>& loads,
                                    const ContactField& contact) -> Result<UnitResponse> {
        const AddedTime time(ms.solve);
        if (!contact.near.empty()) {  // the stress is found at last, without what is known of it
            Result<ReducedModel::Whole> whole = reduced.model.respondAsAWhole(loads, kept);
            if (!whole) return Error{whole.error()};
            return UnitResponse{whole.value().strain_energy_j, std::move(whole.value().modes)};
        }
        Result<ReducedResponse> answer = reduced.model.respond(loads, kept);
        if (!answer) return Error{answer.error()};
        response = std::move(answer).value();
        return UnitResponse{response.strain_energy_j, reduced.model.struckModes(loads)};
    };
    Result<BlowForces> forces =
        blowForces(struck.solid, struck.fracture.contact, blow, solve, {struck.solid.spacing()}, ms);
    if (!forces) return Error{forces.error()};
    found.level = Level::reduced;
    found.forces = std::move(forces).value();
    found.warnings = reduced.warnings;
    if (found.forces.strike.empty()) return success();
    if (!found.forces.contact.near.empty()) {
        const AddedTime time(ms.solve);
        const auto remainder = contactRemainder(reduced.model.problem(), reduced.reading.points(),
                                                reduced.reading.faces(), found.forces.contact);
        if (!remainder) return Error{remainder.error()};
        Result<ReducedResponse> rest = reduced.model.respond(remainder.value(), kept);
        if (!rest) return Error{rest.error()};
        response = std::move(rest).value();
    }
    const AddedTime time(ms.damage);
    const BreakableSolid& solid = struck.solid;
    const Strength at_points{solid.failureCriterion(), solid.material(), strength.atPoints(reduced.reading)};
    const BlowForces& acting = found.forces;
    const ContactReading pressed = reduced.reading.contactReading(acting.contact);
    const ContactReading free = reduced.reading.contactReading({});
    constexpr double faint = 1e-6;  // of the peak: the contact is over
    const AddDamageAt add_damage_at = [&](const VibrationState& state, Damage& sum) {
        const auto add = [&](const Eigen::VectorXf& unknowns, const ContactReading& contact, double scale) {
            reduced.reading.addDamage(unknowns, contact, scale, at_points, sum);
        };
        if (state.modes.size() == 0) return add(response.unknowns, pressed, state.force_n);
        const Eigen::VectorXf swing =
            reduced.model.vibration(state.modes - state.force_n * acting.modes.work);
        if (!(state.force_n > faint * acting.pulse.peak_force_n)) return add(swing, free, 1);
        add(response.unknowns + swing / static_cast<float>(state.force_n), pressed, state.force_n);
    };
    found.damage = damageOverTime(found.forces, crackEnergy(struck), add_damage_at);
    return success();
}

void solveFully(const StrikeContext& struck, const Blow& blow, const BodyStrength& strength, StageTimes& ms,
                BlowDamage& found) {
    BlowStress stress = valueOrFail(blowStress(struck, blow, ms));
    found.level = stress.strike.empty() ? Level::gate : Level::full;  // nothing presses: nothing was solved
    found.residual_rel = stress.unit.residual_rel;
    found.warnings = stress.unit.warnings;
    if (!stress.strike.empty()) {
        const AddedTime time(ms.damage);
        const Discretisation& sampling = *valueOrFail(struck.solid.completeDiscretisation());
        const Strength at_samples = strengthAtSamples(struck.solid, strength);
        const AddDamageAt add_damage_at = [&](const VibrationState& state, Damage& sum) {
            if (state.modes.size() == 0)
                return addDamage(
                    damagedParticles(stress.unit, state.force_n, sampling, at_samples, {}, stress.places),
                    sum);
            const StressField field =
                valueOrFail(stressAt(stress, state, *valueOrFail(struck.solid.stressSolver()),
                                     struck.solid.reducedStress()->model));
            addDamage(damagedParticles(field, 1, sampling, at_samples, {}, stress.places), sum);
        };
        found.damage = damageOverTime(stress, crackEnergy(struck), add_damage_at);
    }
    found.forces = std::move(stress);
}

}  // namespace

BlowDamage blowDamage(const StrikeContext& struck, const Blow& blow, const BodyStrength& strength,
                      StageTimes& ms) {
    BlowDamage found;
    const ReducedStress* reduced = struck.fracture.use_reduced_model ? struck.solid.reducedStress() : nullptr;
    const Status answered =
        reduced ? askReducedModel(struck, *reduced, blow, strength, ms, found) : success();
    if (reduced && answered) return found;
    solveFully(struck, blow, strength, ms, found);
    if (!answered)
        found.warnings.push_back("The prepared model could not answer this blow, so it was solved in full: " +
                                 answered.error());
    return found;
}

}  // namespace sherd
