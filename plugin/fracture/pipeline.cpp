#include "fracture/pipeline.h"

#include <optional>
#include <utility>

#include "core/damage/damage.h"
#include "core/loads/contact_loads.h"
#include "fracture/add_sentence.h"
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

void noteDamage(const Damage& damage, BlowOutcome& out) {
    out.largest_stress_pa = damage.largest_stress_pa;
    out.damaged_particles = damage.count;
}

/// What earlier blows damaged is damaged still.
void addEarlier(const StrikeContext& struck, Damage& damage) {
    if (!struck.earlier) return;
    const std::vector<char> earlier = struck.earlier->particles(struck.sampling);
    damage.count = 0;
    for (std::size_t i = 0; i < earlier.size(); ++i)
        damage.count += damage.damaged[i] = damage.damaged[i] || earlier[i];
}

void keepDamage(const StrikeContext& struck, const Damage& damage, BlowOutcome& out) {
    out.damaged = DamagedMaterial::with(struck.earlier, struck.sampling, damage.damaged);
}

constexpr const char* beyond_elasticity =
    "The largest stress is above Young's modulus, which no elastic body has: a part carries it that is much "
    "thinner than the particles are apart (use a smaller spacing or a higher quality), or masses and speeds "
    "are in other units.";

struct Pieces {
    FragmentLabels labels;
    FragmentSurfaces surfaces;
};

/// What the damage makes of the body. Nothing where that stays in one piece: it keeps the damage.
std::optional<Pieces> piecesOf(const StrikeContext& struck, const BlowDamage& found, BlowOutcome& out) {
    out.damaged = nullptr;  // of an attempt before
    out.message.clear();
    Damage damage = found.damage;
    addEarlier(struck, damage);
    damage =
        valueOrFail(furtherWaves(struck, found.forces.loads, out.peak_force_n, std::move(damage), out.ms));
    noteDamage(damage, out);
    Pieces pieces;
    pieces.labels = timed(out.ms.cluster, [&] { return labelParticles(struck, damage, found.forces); });
    if (pieces.labels.count >= 2)
        pieces.surfaces =
            valueOrFail(timed(out.ms.surface, [&] { return cutPieces(struck, pieces.labels); }));
    for (const std::string& note : pieces.surfaces.notes) addSentence(out.message, note);
    if (pieces.surfaces.pieces.size() >= 2) return pieces;
    keepDamage(struck, damage, out);
    return std::nullopt;
}

/// A blow that `canBreak` lets through
///   -> loads of 1 N in total -> what the supports answer, stress per newton, peak force, strain energy,
///      by the reduced model or a full solve
///   -> damaged particles                    held: there are none, or the energy pays for no crack
///      and those of earlier blows
///   -> more damage, solved without those    (settings.damage_waves; none by default)
///   -> a label for each particle            held: all have the same; the damage stays
///   -> pieces cut out of the surface        held: there is only one; the damage stays
///      What the contact leaves in one piece rings, and is damaged and labelled once more by that.
///   -> a fragment for each piece: a solid, and boxes for collisions.
/// What a stage throws ends in `failed`. The solid keeps no damage: the body does.
void runStages(const BreakableSolid& solid, const Blow& blow, const FractureSettings& fracture,
               std::uint64_t seed, const std::shared_ptr<const DamagedMaterial>& earlier, BlowOutcome& out) {
    out.level = Level::full;  // also of what fails below
    out.impulse_n_s = normalImpulse(blow);
    const Discretisation& sampling = samplingOf(solid, out.ms);
    const StrikeContext struck{solid, sampling, fracture, seed, earlier};
    BlowDamage found = blowDamage(struck, blow, solid.strength(), out.ms);
    out.level = found.level;
    const BlowForces& forces = found.forces;
    if (forces.strike.empty()) return;
    out.peak_force_n = forces.pulse.peak_force_n;
    out.contact_time_s = forces.pulse.duration_s;
    out.residual_rel = found.residual_rel;
    out.warnings = found.warnings;
    noteDamage(found.damage, out);
    if (found.damage.count == 0 || forces.strain_energy_j < smallestCrackEnergy(solid, fracture)) return;
    std::optional<Pieces> pieces = piecesOf(struck, found, out);
    if (!pieces && found.add_ringing) {
        timed(out.ms.damage, [&] { found.add_ringing(found); });
        pieces = piecesOf(struck, found, out);
    }
    if (!pieces) return;

    const AddedTime making(out.ms.fragments);
    out.crack_area_m2 = crackArea(pieces->surfaces);
    out.fragments = makeFragments(struck, pieces->labels, std::move(pieces->surfaces));
    if (fracture.debris == Debris::dropped) markDropped(smallestFragment(solid, fracture), out.fragments);
    const ConservationErrors errors = conservationErrors(solid, out.fragments);
    out.mass_error_rel = errors.mass_rel;
    out.volume_error_rel = errors.volume_rel;
    out.outcome = Outcome::broke;
}

}  // namespace

BlowOutcome strike(const BreakableSolid& solid, const Blow& blow, const FractureSettings& fracture,
                   std::uint64_t seed, const std::shared_ptr<const DamagedMaterial>& earlier) {
    return failedIfThrown([&](BlowOutcome& out) {
        runStages(solid, blow, fracture, seed, earlier, out);
        if (out.largest_stress_pa > solid.material().youngs_modulus_pa)
            out.warnings.push_back(beyond_elasticity);
    });
}

}  // namespace sherd
