#include "fracture/pipeline.h"

#include <algorithm>

#include "core/damage/damage.h"
#include "core/loads/contact_loads.h"
#include "fracture/blow_stress.h"
#include "fracture/conservation.h"
#include "fracture/crack_energy.h"
#include "fracture/cut_within_limit.h"
#include "fracture/damage_waves.h"
#include "fracture/debris.h"
#include "fracture/failed_if_thrown.h"
#include "fracture/label_particles.h"
#include "fracture/stage.h"

namespace sherd {

namespace {

/// The factored stress problem of the solid. The first blow makes it, unless `prepare` did, and reports what
/// it took; so it does for the sampling, which may have been made before it.
const StressSolver& solverOf(const BreakableSolid& solid, StageTimes& ms) {
    const bool known = solid.prepared();
    const StressSolver& solver = *valueOrFail(solid.stressSolver());
    if (!known) {
        ms.sample = solid.sampleMilliseconds();
        ms.assemble = solver.report().assemble_ms;
        ms.factor = solver.report().factor_ms;
    }
    return solver;
}

void addSentence(std::string& message, const std::string& sentence) {
    message += (message.empty() ? "" : " ") + sentence;
}

void noteDamage(const Damage& damage, BlowOutcome& out) {
    out.largest_stress_pa = damage.largest_stress_pa;
    out.damaged_particles = damage.count;
}

/// A blow that `canBreak` lets through
///   -> loads of 1 N in total -> what the supports answer, stress per newton, peak force, strain energy
///   -> damaged particles                    held: there are none, or the energy pays for no crack
///   -> more damage, solved without those    (settings.damage_waves; none by default)
///   -> a label for each particle            held: all have the same
///   -> pieces cut out of the surface        held: there is only one
///   -> a fragment for each piece: a solid, and boxes for collisions.
/// What a stage throws ends in `failed`. The solid keeps no damage, so each blow finds it whole.
void runStages(const BreakableSolid& solid, const Blow& blow, const FractureSettings& fracture,
               std::uint64_t seed, BlowOutcome& out) {
    out.impulse_n_s = normalImpulse(blow);
    const StressSolver& solver = solverOf(solid, out.ms);
    const Discretisation& sampling = *valueOrFail(solid.discretisation());  // the solid keeps it
    const StrikeContext struck{solid, sampling, fracture, seed};

    const BlowStress stress = valueOrFail(blowStress(struck, solver, blow, out.ms));
    if (stress.strike.empty()) return;
    const double peak_force_n = stress.pulse.peak_force_n;
    out.peak_force_n = peak_force_n;
    out.contact_time_s = stress.pulse.duration_s;
    out.residual_rel = stress.unit.residual_rel;
    out.warnings = stress.unit.warnings;

    const Strength strength{solid.failureCriterion(), solid.material(), solid.strengths(sampling)};
    Damage damage =
        timed(out.ms.damage, [&] { return damagedParticles(stress.unit, peak_force_n, sampling, strength); });
    noteDamage(damage, out);
    if (damage.count == 0 || stress.strain_energy_j < smallestCrackEnergy(solid, fracture)) return;
    damage =
        valueOrFail(furtherWaves(struck, stress.loads, peak_force_n, strength, std::move(damage), out.ms));
    noteDamage(damage, out);

    FragmentLabels labels = timed(out.ms.cluster, [&] {
        return labelParticles(struck, damage, stress.strain_energy_j, axisOf(stress.strike));
    });
    if (labels.count < 2) return;

    const FragmentSurfaces surfaces =
        valueOrFail(timed(out.ms.surface, [&] { return cutWithinLimit(struck, labels); }));
    for (const std::string& note : surfaces.notes) addSentence(out.message, note);
    if (surfaces.pieces.size() < 2) return;

    out.fragments = makeFragments(struck, labels, surfaces);
    if (fracture.debris == Debris::dropped) markDropped(smallestFragment(solid, fracture), out.fragments);
    const ConservationErrors errors = conservationErrors(solid, out.fragments);
    out.mass_error_rel = errors.mass_rel;
    out.volume_error_rel = errors.volume_rel;
    out.outcome = Outcome::broke;
}

}  // namespace

BlowOutcome strike(const BreakableSolid& solid, const Blow& blow, const FractureSettings& fracture,
                   std::uint64_t seed) {
    return failedIfThrown([&](BlowOutcome& out) { runStages(solid, blow, fracture, seed, out); });
}

}  // namespace sherd
