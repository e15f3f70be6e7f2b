#include "fracture/blow_stress.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/loads/support_answer.h"
#include "core/numerics/stopwatch.h"
#include "core/stress/elasticity.h"
#include "core/stress/surface_traction.h"
#include "fracture/blow_damage.h"

namespace sherd {

namespace {

constexpr int most_solves = 4;         // of one blow
constexpr double same_answer = 0.005;  // of the strike: a change of the answer that changes nothing

constexpr double least_part = 0.1;    // of a body's energy that is not about the patches, at least
constexpr double least_share = 0.02;  // of a strike on another body: with less, nothing is heard of it

/// Sum of the forces that push along `direction`, N.
double forceAlong(const Vec3& direction, const std::vector<PointForce>& forces) {
    double sum = 0;
    for (const PointForce& force : forces) sum += std::max(0.0, force.force.dot(direction));
    return sum;
}

std::vector<PointForce> scaled(std::vector<PointForce> forces, double factor) {
    for (PointForce& force : forces) force.force *= factor;
    return forces;
}

std::vector<PointForce> together(std::vector<PointForce> forces, const std::vector<PointForce>& more) {
    forces.insert(forces.end(), more.begin(), more.end());
    return forces;
}

/// Shortening over force of a body as a rod along a direction: as long as it is, and of its volume, m/N.
double rodCompliance(const ContactBody& body, const Vec3& along) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vec3& vertex : body.surface.surface().vertices) {
        low = std::min(low, vertex.dot(along));
        high = std::max(high, vertex.dot(along));
    }
    const double volume = body.mobility.mass() / body.material.density_kg_m3;
    return (high - low) * (high - low) / (body.material.youngs_modulus_pa * volume);
}

/// The forces on a body that nothing strikes, from a strike on another body of its stack: what its beds do
/// under 1 N there, made into 1 N on the side that the load comes from. The stack stores what rods do, this
/// body included: so the force is the same that the others hear of.
Result<BlowForces> squeezingForces(const BreakableSolid& solid, const ContactSettings& contact,
                                   const Blow& blow, const StressOfLoads& solve, StageTimes& ms) {
    const AddedTime time(ms.loads);
    const ContactBody body = struckBody(solid, blow);
    const Stack& stack = blow.stack;
    const Strike strike = strikeOn(stack);
    const auto foundations = foundationsOf(body, blow, {}, contact);
    const double compliance = rodCompliance(body, stack.strike.push);
    BlowForces forces;
    forces.pulse = contactPulse(impactOf(strike, 1), 0, contact.shortest_contact_s);
    SupportAnswer answer;
    double pressed = 0;
    for (int round = 0; round < most_solves; ++round) {
        answer = supportAnswer(body, foundations, {}, forces.pulse.duration_s, stack, answer.pressed);
        const double before = pressed;
        pressed = forceAlong(stack.strike.push, answer.forces);
        if (!(pressed > least_share)) return BlowForces{};
        if (std::abs(pressed - before) < same_answer) break;
        forces.pulse = contactPulse(impactOf(strike, answer.held),
                                    0.5 * compliance * pressed * pressed + answer.others_energy_j,
                                    contact.shortest_contact_s);
    }
    forces.pulse.peak_force_n *= pressed;
    forces.loads = scaled(answer.forces, 1 / pressed);
    for (const PointForce& load : forces.loads)
        if (load.force.dot(stack.strike.push) > 0) forces.strike.push_back(load);
    forces.contact.others = forces.loads;
    constexpr double at_rest = std::numeric_limits<double>::infinity();
    const Result<UnitResponse> unit = solve(forces.loads, forces.contact, at_rest);
    if (!unit) return Error{unit.error()};
    forces.strain_energy_j =
        std::min(unit.value().strain_energy_j * forces.pulse.peak_force_n * forces.pulse.peak_force_n,
                 stack.largestEnergy());
    return forces;
}

/// How long a contact lasts on a body that does not give way, s. Infinite where nothing is struck: that is no
/// impact on vibrations.
double shortestContact(const Impact& impact, double shortest_s) {
    if (!(impact.hertz_force_n > 0)) return std::numeric_limits<double>::infinity();
    return std::max(pulseDuration(impact.hertz_force_n, impact.mass_kg * impact.speed_m_s), shortest_s);
}

/// The pulse of an impact, and what of the body's vibrations goes with it.
void strikeBody(const Impact& impact, StruckBody body, double shortest_s, BlowForces& forces) {
    const double body_energy_j =
        std::max(body.strain_energy_j_n2 - body.patch_energy_j_n2, least_part * body.strain_energy_j_n2);
    forces.pulse = contactPulse(impact, body_energy_j + body.others_energy_j_n2, shortest_s);
    forces.strain_energy_j = body.strain_energy_j_n2 * forces.pulse.peak_force_n * forces.pulse.peak_force_n;
    forces.pressed.clear();
    forces.ringing.clear();
    if (!(impact.hertz_force_n > 0)) return;
    if (isQuasiStatic(body.modes.slowestPeriod(), shortestContact(impact, shortest_s))) return;
    ModalImpact found = modalImpact(impact, body, shortest_s);
    forces.pulse = found.pulse;
    forces.strain_energy_j = 0;
    for (const VibrationState& state : found.pressed)
        forces.strain_energy_j = std::max(forces.strain_energy_j, state.energy_j);
    forces.modes = std::move(body.modes);
    forces.pressed = std::move(found.pressed);
    forces.ringing = std::move(found.ringing);
}

}  // namespace

ContactBody struckBody(const BreakableSolid& solid, const Blow& blow) {
    const Mobility free = Mobility::of(solid.moments(), solid.material().density_kg_m3);
    return {solid.surfaceTree(), solid.material(), blow.free_turns ? free.heldBack(*blow.free_turns) : free,
            solid.wallThickness(), solid.boundingRadius()};
}

bool isHeld(const BreakableSolid& solid, const Blow& blow) {
    return solid.isAnchored() || blow.isSupported();
}

double broughtEnergy(const BreakableSolid& solid, const Blow& blow, const Strike& strike) {
    return impactOf(strike, isHeld(solid, blow) ? 1 : 0).energy();
}

Result<StressField> unitStress(const StrikeContext& struck, const StressSolver& solver,
                               const std::vector<PointForce>& unit_loads, StageTimes& ms) {
    const auto sampling = struck.solid.completeDiscretisation();
    if (!sampling) return Error{sampling.error()};
    const Stopwatch watch;
    Result<StressField> stress = solver.solve(unit_loads);
    if (!stress) return stress;
    freeSurface(*sampling.value(), unit_loads, Elasticity(struck.solid.material()), stress.value().surface);
    ms.solve += stress.value().solve_ms;
    ms.stress += watch.milliseconds() - stress.value().solve_ms;
    return stress;
}

Result<BlowForces> blowForces(const BreakableSolid& solid, const ContactSettings& contact, const Blow& blow,
                              const StressOfLoads& solve, const SolvingGrid& grid, StageTimes& ms) {
    const ContactBody body = struckBody(solid, blow);
    if (blow.isSqueezed()) return squeezingForces(solid, contact, blow, solve, ms);
    const Strike strike = timed(ms.loads, [&] { return strikeOf(body, blow, contact); });
    BlowForces forces;
    const auto patches = timed(ms.loads, [&] { return contactPatches(body, strike, contact); });
    forces.strike = forces.loads = unitLoads(patches);
    if (forces.strike.empty()) return forces;
    // Finer grids around the contacts see the near field themselves.
    const StressSettings& stress = solid.settings().stress;
    if (grid.near_fields && stress.trial_function == TrialFunction::spline && !stress.resample_contacts)
        forces.contact = timed(ms.loads, [&] { return contactField(body, patches, grid.spacing_m); });
    SupportAnswer answer;
    std::vector<Foundation> foundations;
    if (solid.isAnchored())  // its supports are part of the stress problem
        answer.held = 1;
    else
        foundations = timed(ms.loads, [&] { return foundationsOf(body, blow, strike, contact); });

    const double patch_energy_j = patchEnergy(body, strike, contact, solid.spacing());
    const double unseen_j = patch_energy_j - patchEnergy(body, strike, contact, grid.spacing_m);
    double brought_j = 0;
    for (int solved = 1; solved <= most_solves; ++solved) {
        const Impact impact = impactOf(strike, answer.held);
        Result<UnitResponse> unit =
            solve(forces.loads, forces.contact, shortestContact(impact, contact.shortest_contact_s));
        if (!unit) return Error{unit.error()};
        strikeBody(impact,
                   {std::move(unit.value().modes), unit.value().strain_energy_j + unseen_j, patch_energy_j,
                    answer.others_energy_j},
                   contact.shortest_contact_s, forces);
        brought_j = impact.energy();
        if (foundations.empty()) break;
        SupportAnswer next = timed(ms.loads, [&] {
            return supportAnswer(body, foundations, forces.strike, forces.pulse.duration_s, blow.stack,
                                 answer.pressed);
        });
        if (std::abs(next.sum_n - answer.sum_n) < same_answer || solved == most_solves) break;
        answer = std::move(next);
        forces.loads = together(forces.strike, answer.forces);
    }
    if (forces.contact.near.empty()) forces.contact.others = forces.strike;
    forces.contact.others = together(std::move(forces.contact.others), answer.forces);
    // The contact does not feel all that it gives the modes, since it stores part of that itself.
    forces.strain_energy_j = std::min(forces.strain_energy_j, brought_j);
    for (VibrationState& state : forces.ringing) state.energy_j = std::min(state.energy_j, brought_j);
    return forces;
}

Result<StressField> stressAt(const BlowStress& stress, const VibrationState& state,
                             const StressSolver& solver, const ReducedModel& model) {
    StressField sum = stress.unit;
    const Eigen::ArrayXd beyond = state.modes - state.force_n * stress.modes.work;
    const auto more =
        solver.stressOfUnknowns(model.vibration(stress.modes, beyond).cast<double>(), stress.contact);
    if (!more) return more;
    const auto add = [&](std::vector<SymmetricTensor>& all, const std::vector<SymmetricTensor>& own) {
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = state.force_n * all[i] + own[i];
    };
    add(sum.particles, more.value().particles);
    add(sum.surface, more.value().surface);
    add(sum.points, more.value().points);
    return sum;
}

Result<BlowStress> blowStress(const StrikeContext& struck, const Blow& blow, StageTimes& ms) {
    const auto solver = [&]() -> const StressSolver& { return solverOf(struck.solid, ms); };
    BlowStress stress;
    const ReducedStress* reduced = struck.solid.reducedStress();  // knows the vibrations
    ReducedModel::LocalSystem kept;
    const StressOfLoads solve = [&](const std::vector<PointForce>& loads, const ContactField& contact,
                                    double contact_s) -> Result<UnitResponse> {
        UnitResponse response;
        if (reduced) response.modes = reduced->model.struckModes(loads, contact_s, kept);
        if (!contact.near.empty()) {  // the stress is found at last, without what is known of it
            const StressSolver& factored = solver();  // whose making has times of its own
            const AddedTime time(ms.solve);
            const Result<double> energy = factored.strainEnergy(loads);
            if (!energy) return Error{energy.error()};
            response.strain_energy_j = energy.value();
            return response;
        }
        Result<StressField> unit = unitStress(struck, solver(), loads, ms);
        if (!unit) return Error{unit.error()};
        stress.unit = std::move(unit).value();
        response.strain_energy_j = stress.unit.strain_energy_j;
        return response;
    };
    Result<BlowForces> forces =
        blowForces(struck.solid, struck.fracture.contact, blow, solve, {struck.solid.spacing()}, ms);
    if (!forces) return Error{forces.error()};
    static_cast<BlowForces&>(stress) = std::move(forces).value();
    if (stress.contact.near.empty()) return stress;
    Result<StressField> unit = solver().solveContact(stress.contact);
    if (!unit) return Error{unit.error()};
    stress.unit = std::move(unit).value();
    ms.solve += stress.unit.solve_ms;
    ms.stress += stress.unit.recovery_ms;
    const double peak = stress.pulse.peak_force_n;
    stress.unit.strain_energy_j = peak > 0 ? stress.strain_energy_j / (peak * peak) : 0;
    for (const SurfacePlace& place : stress.contact.places) stress.places.push_back(place.position);
    return stress;
}

}  // namespace sherd
