#include "fracture/blow_damage.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

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

/// Where nothing presses, nothing was solved.
Level levelOf(const BlowForces& forces, Level solved) {
    return forces.strike.empty() ? Level::gate : solved;
}

/// Of the contact, and of what rings after it, unless the contact alone may have the body in pieces by then.
void damageOverTime(const StrikeContext& struck, AddDamageAt add_damage_at, BlowDamage& found) {
    const double crack_j = smallestCrackEnergy(struck.solid, struck.fracture);
    // What is faint beside a contact that crushes may still pull the body apart, if it pays for a crack.
    std::vector<VibrationState>& ringing = found.forces.ringing;
    const auto does_nothing = [&](const VibrationState& state) {
        return state.is_faint && state.energy_j < crack_j;
    };
    ringing.erase(std::remove_if(ringing.begin(), ringing.end(), does_nothing), ringing.end());
    found.damage = damageOfContact(found.forces, add_damage_at);
    if (ringing.empty()) return;
    found.add_ringing = [add_damage_at = std::move(add_damage_at)](BlowDamage& blow) {
        addRinging(blow.forces, add_damage_at, blow.damage);
        blow.add_ringing = nullptr;
    };
    if (found.damage.count == 0 || found.forces.strain_energy_j < crack_j) found.add_ringing(found);
}

/// An error if the reduced model cannot answer.
Status askReducedModel(const StrikeContext& struck, const ReducedStress& reduced, const Blow& blow,
                       const BodyStrength& strength, StageTimes& ms, BlowDamage& found) {
    ReducedResponse response;
    ReducedModel::LocalSystem kept;
    const StressOfLoads solve = [&](const std::vector<PointForce>& loads, const ContactField& contact,
                                    double contact_s) -> Result<UnitResponse> {
        const AddedTime time(ms.solve);
        UnitResponse unit{0, reduced.model.struckModes(loads, contact_s, kept)};
        if (!contact.near.empty()) {  // the stress is found at last, without what is known of it
            const Result<double> energy = reduced.model.strainEnergy(loads, kept);
            if (!energy) return Error{energy.error()};
            unit.strain_energy_j = energy.value();
            return unit;
        }
        Result<ReducedResponse> answer = reduced.model.respond(loads, kept);
        if (!answer) return Error{answer.error()};
        response = std::move(answer).value();
        unit.strain_energy_j = response.strain_energy_j;
        return unit;
    };
    Result<BlowForces> forces =
        blowForces(struck.solid, struck.fracture.contact, blow, solve, {struck.solid.spacing()}, ms);
    if (!forces) return Error{forces.error()};
    found.forces = std::move(forces).value();
    found.level = levelOf(found.forces, Level::reduced);
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
    const double faint_n = 1e-6 * found.forces.pulse.peak_force_n;  // the contact is over
    AddDamageAt add_damage_at = [&reduced, at_points, faint_n, unknowns = std::move(response.unknowns),
                                 pressed = reduced.reading.contactReading(found.forces.contact),
                                 free = reduced.reading.contactReading({}),
                                 modes = found.forces.modes](const VibrationState& state, Damage& sum) {
        const auto add = [&](const Eigen::VectorXf& read, const ContactReading& contact, double scale) {
            reduced.reading.addDamage(read, contact, scale, at_points, sum);
        };
        if (state.modes.size() == 0) return add(unknowns, pressed, state.force_n);
        const Eigen::VectorXf swing =
            reduced.model.vibration(modes, state.modes - state.force_n * modes.work);
        if (!(state.force_n > faint_n)) return add(swing, free, 1);
        add(unknowns + swing / static_cast<float>(state.force_n), pressed, state.force_n);
    };
    damageOverTime(struck, std::move(add_damage_at), found);
    return success();
}

void solveFully(const StrikeContext& struck, const Blow& blow, const BodyStrength& strength, StageTimes& ms,
                BlowDamage& found) {
    const auto stress = std::make_shared<const BlowStress>(valueOrFail(blowStress(struck, blow, ms)));
    found.level = levelOf(*stress, Level::full);
    found.residual_rel = stress->unit.residual_rel;
    found.warnings = stress->unit.warnings;
    found.forces = *stress;
    if (stress->strike.empty()) return;
    const AddedTime time(ms.damage);
    const Discretisation& sampling = *valueOrFail(struck.solid.completeDiscretisation());
    AddDamageAt add_damage_at = [stress, &sampling, &solid = struck.solid,
                                 at_samples = strengthAtSamples(struck.solid, strength)](
                                    const VibrationState& state, Damage& sum) {
        if (state.modes.size() == 0)
            return addDamage(
                damagedParticles(stress->unit, state.force_n, sampling, at_samples, {}, stress->places), sum);
        const StressField field = valueOrFail(
            stressAt(*stress, state, *valueOrFail(solid.stressSolver()), solid.reducedStress()->model));
        addDamage(damagedParticles(field, 1, sampling, at_samples, {}, stress->places), sum);
    };
    damageOverTime(struck, std::move(add_damage_at), found);
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
