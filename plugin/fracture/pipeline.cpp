#include "fracture/pipeline.h"

#include <algorithm>
#include <cmath>
#include <exception>

#include "core/clustering/clusters.h"
#include "core/clustering/merge_labels.h"
#include "core/damage/damage.h"
#include "core/damage/particle_strengths.h"
#include "core/loads/contact_loads.h"
#include "core/loads/contact_pulse.h"
#include "core/numerics/stopwatch.h"
#include "core/stress/surface_traction.h"
#include "fracture/damage_waves.h"
#include "fracture/fragments.h"
#include "geometry/cutting/fragment_surfaces.h"

namespace sherd {

namespace {

/// A stage that could not be done; the body stays whole.
struct StageFailed {
    std::string message;
};

template <class T>
T require(Result<T> result) {
    if (!result) throw StageFailed{result.error()};
    return std::move(result).value();
}

template <class Stage>
auto timed(double& milliseconds, const Stage& stage) {
    const Stopwatch watch;
    auto result = stage();
    milliseconds = watch.milliseconds();
    return result;
}

void addSentence(std::string& message, const std::string& sentence) {
    if (!sentence.empty()) message += (message.empty() ? "" : " ") + sentence;
}

const StressSolver& preparedSolver(const BreakableSolid& body, StageTimes& ms) {
    const bool known = body.prepared();
    const StressSolver& solver = *require(body.stressSolver());
    if (!known) {
        ms.sample = body.sampleMilliseconds();
        ms.assemble = solver.report().assemble_ms;
        ms.factor = solver.report().factor_ms;
    }
    return solver;
}

/// A fragment may come apart in the cut, at a neck of few particles. Where that makes more pieces than the
/// settings allow, the smallest fragments are merged to make room, and the body is cut again.
FragmentSurfaces cutWithinLimit(const BreakableSolid& body, const Discretisation& solid,
                                FragmentLabels& labels, std::uint64_t seed) {
    const FractureSettings& fracture = body.settings().fracture;
    while (true) {
        FragmentSurfaces surfaces =
            require(cutFragments(body.surface(), solid, labels, {seed, fracture.crack_roughness}));
        const int count = labels.count,
                  excess = static_cast<int>(surfaces.pieces.size()) - fracture.largest_fragment_count;
        if (excess > 0) mergeSmallest(solid, 0, std::max(2, count - excess), labels);
        if (excess <= 0 || labels.count == count) return surfaces;
    }
}

/// The pipeline on one screen: blow -> loads -> stress -> damage -> clusters -> surfaces -> fragments (paper,
/// Figure 1).
void runStages(const BreakableSolid& body, const Blow& blow, std::uint64_t seed, BlowOutcome& out) {
    const Settings& settings = body.settings();
    const Material& material = body.material();
    const StruckBody struck{body.surface(), material, body.wallThickness(), body.boundingRadius()};

    const StressSolver& solver = preparedSolver(body, out.ms);
    const Discretisation& solid = *require(body.discretisation());

    const ContactLoads loads = contactLoads(struck, blow, settings.contact);
    StressField unit_stress = require(solver.solve(loads.unit));
    freeSurface(solid, loads.unit, Elasticity(material), unit_stress.surface);
    const ContactPulse pulse =
        contactPulse(loads.hertz_force_n, unit_stress.strain_energy_j, loads.mass_kg, loads.speed_m_s,
                     settings.contact.shortest_contact_s, settings.contact.longest_contact_s);
    const double energy = unit_stress.strain_energy_j * pulse.peak_force_n * pulse.peak_force_n;
    out.peak_force_n = pulse.peak_force_n;
    out.contact_time_s = pulse.duration_s;
    out.residual_rel = unit_stress.residual_rel;
    out.ms.solve = unit_stress.solve_ms;
    out.ms.stress = unit_stress.recovery_ms;

    const Strength strength{body.failureCriterion(), material, body.strengths(solid)};
    Damage damage = timed(out.ms.damage,
                          [&] { return damagedParticles(unit_stress, pulse.peak_force_n, solid, strength); });
    out.largest_stress_pa = damage.largest_stress_pa;
    out.damaged_particles = damage.count;
    if (damage.count == 0 || energy < smallestCrackEnergy(body)) return;
    damage = require(furtherWaves(body, loads.unit, pulse.peak_force_n, strength, std::move(damage), out.ms));
    out.damaged_particles = damage.count;

    FragmentLabels labels = timed(out.ms.cluster, [&] {
        const int wanted = wantedClusters(body, damage, solid, energy);
        FragmentLabels clustered = fragmentLabels(solid, damage, wanted, body.wallThickness(), seed,
                                                  settings.fracture.guide, axisOf(loads.unit));
        const bool merging = settings.fracture.debris == Debris::merged;
        mergeSmallest(solid, merging ? body.smallestFragment() : 0, settings.fracture.largest_fragment_count,
                      clustered);
        return clustered;
    });
    if (labels.count < 2) return;

    const FragmentSurfaces surfaces =
        timed(out.ms.surface, [&] { return cutWithinLimit(body, solid, labels, seed); });
    for (const std::string& note : surfaces.notes) addSentence(out.message, note);
    if (surfaces.pieces.size() < 2) return;

    out.fragments = makeFragments(body, solid, labels, surfaces);
    out.outcome = BreakEvent::Outcome::broke;
}

}  // namespace

bool canBreak(const BreakableSolid& body, const Blow& blow) {
    // The body can store no more than the blow brings, and both of these must be paid for:
    // a particle that fails stores at least what the criterion says; and a crack through the thinnest section
    // costs its faces (Griffith).
    const double energy = blowEnergy(blow);
    if (!(energy > smallestCrackEnergy(body))) return false;
    const Material& m = body.material();
    const double share = std::min(std::pow(body.spacing(), 3), body.moments().volume);
    const double s = m.tensile_strength_pa * weakestStrengthFraction(m, share) * body.weakestPlace();
    const double density = body.failureCriterion().least_energy_density_j_m3(s, m);
    return energy > density * body.settings().sampling.smallest_fill * share;
}

BlowOutcome strike(const BreakableSolid& body, const Blow& blow, std::uint64_t seed) {
    BlowOutcome out;
    for (const ContactImpulse& c : blow.contacts) out.impulse_n_s += std::max(0.0, c.impulse.dot(c.normal));
    try {
        runStages(body, blow, seed, out);
    } catch (const StageFailed& failure) {
        out.message = failure.message;
        out.outcome = BreakEvent::Outcome::failed;
    } catch (const std::exception& failure) {
        // Out of memory, or a library's own check: nothing may leave through Bullet's step.
        out.message =
            std::string("The blow could not be worked out (") + failure.what() + "); the body stays whole.";
        out.outcome = BreakEvent::Outcome::failed;
    } catch (...) {
        out.message =
            "The blow could not be worked out: a strength field or guide field threw what is no "
            "std::exception; the body "
            "stays whole.";
        out.outcome = BreakEvent::Outcome::failed;
    }
    if (out.outcome != BreakEvent::Outcome::broke) out.fragments.clear();
    if (!out.fragments.empty()) addConservationErrors(body, out);
    if (body.settings().fracture.debris == Debris::dropped) markDropped(body, out.fragments);
    return out;
}

}  // namespace sherd
