#include "fracture/pipeline.h"

#include <utility>

#include "core/damage/damage.h"
#include "core/loads/contact_loads.h"
#include "fracture/blow_damage.h"
#include "fracture/conservation.h"
#include "fracture/crack_energy.h"
#include "fracture/damage_waves.h"
#include "fracture/debris.h"
#include "fracture/failed_if_thrown.h"
#include "fracture/label_particles.h"
#include "fracture/stage.h"

namespace sherd {

namespace {

const Discretisation& samplingOf(const BreakableSolid& solid, StageTimes& ms) {
    if (solid.sampleMilliseconds() > 0) return *valueOrFail(solid.discretisation());
    return *valueOrFail(timed(ms.sample, [&] { return solid.discretisation(); }));  // the solid keeps it
}

void addSentence(std::string& message, const std::string& sentence) {
    message += (message.empty() ? "" : " ") + sentence;
}

void noteDamage(const Damage& damage, BlowOutcome& out) {
    out.largest_stress_pa = damage.largest_stress_pa;
    out.damaged_particles = damage.count;
}

/// A blow that `canBreak` lets through
///   -> loads of 1 N in total -> what the supports answer, stress per newton, peak force, strain energy,
///      by the reduced model or a full solve
///   -> damaged particles                    held: there are none, or the energy pays for no crack
///   -> more damage, solved without those    (settings.damage_waves; none by default)
///   -> a label for each particle            held: all have the same
///   -> pieces cut out of the surface        held: there is only one
///   -> a fragment for each piece: a solid, and boxes for collisions.
/// What a stage throws ends in `failed`. The solid keeps no damage, so each blow finds it whole.
void runStages(const BreakableSolid& solid, const Blow& blow, const FractureSettings& fracture,
               std::uint64_t seed, BlowOutcome& out) {
    out.level = Level::full;  // also of what fails below
    out.impulse_n_s = normalImpulse(blow);
    const Discretisation& sampling = samplingOf(solid, out.ms);
    const StrikeContext struck{solid, sampling, fracture, seed};
    if (!solid.prepared()) solverOf(solid, out.ms);
    const Strength strength = timed(out.ms.damage, [&] {
        return Strength{solid.failureCriterion(), solid.material(), solid.strengths(sampling)};
    });

    BlowDamage found = blowDamage(struck, blow, strength, out.ms);
    out.level = found.level;
    const BlowForces& forces = found.forces;
    if (forces.strike.empty()) return;
    out.peak_force_n = forces.pulse.peak_force_n;
    out.contact_time_s = forces.pulse.duration_s;
    out.residual_rel = found.residual_rel;
    out.warnings = found.warnings;
    Damage damage = std::move(found.damage);
    noteDamage(damage, out);
    if (damage.count == 0 || forces.strain_energy_j < smallestCrackEnergy(solid, fracture)) return;
    damage = valueOrFail(
        furtherWaves(struck, forces.loads, out.peak_force_n, strength, std::move(damage), out.ms));
    noteDamage(damage, out);

    const FragmentLabels labels = timed(out.ms.cluster, [&] {
        return labelParticles(struck, damage, forces.strain_energy_j, axisOf(forces.strike));
    });
    if (labels.count < 2) return;

    FragmentSurfaces surfaces = valueOrFail(timed(out.ms.surface, [&] { return cutPieces(struck, labels); }));
    for (const std::string& note : surfaces.notes) addSentence(out.message, note);
    if (surfaces.pieces.size() < 2) return;

    const AddedTime making(out.ms.fragments);
    out.fragments = makeFragments(struck, labels, std::move(surfaces));
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
