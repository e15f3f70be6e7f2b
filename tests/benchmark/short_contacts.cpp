// Blows that are short or long for the body they fall on, against a transient solution: 20 balls on a wall, a
// rod and a plate that stand free, prepared at `game`. Truth is the motion of the body under half a sine wave
// with the blow's own peak force and duration, on a grid with up to three times as many unknowns: Newmark's
// method with the average acceleration (beta 1/4), 40 steps in a contact, then 10 in as much time or 400 in a
// period of the slowest vibration, whichever is more, until one such period after the contact; every second
// one is read. Of the contact's near field it has what a static solve has. Neither modes nor anything else of
// the reduced model is used. Usage: short_contacts
//
// Columns: the contact over the slowest period; largest principal stress over the true one: with vibrations,
// as an event has it; the same further from the contact than the body is thick; quasi-static under the same
// force; quasi-static under its own.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "benchmark/value_or_exit.h"
#include "core/mlpg/reduced/reduced_stress.h"
#include "core/numerics/pi.h"
#include "core/stress/principal_stresses.h"
#include "fracture/blow_damage.h"
#include "fracture/blow_stress.h"
#include "support/newmark.h"
#include "support/shapes.h"

namespace {

using namespace sherd;
using namespace sherd::benchmarks;

struct Body {
    std::string name;
    Vec3 size;  ///< m, thinnest along y
    Material material;
};

struct Ball {
    double x = 0, z = 0;  ///< where it strikes, shares of the half size
    double mass_kg = 0, speed_m_s = 0, radius_m = 0, youngs_modulus_pa = 0;
};

Material unbreakable(Material material) {
    material.tensile_strength_pa = 9e9;
    material.compressive_strength_pa = 9e10;
    material.strength_scatter = 0;
    return material;
}

Blow blowOf(const Ball& ball, const Vec3& size) {
    ContactImpulse contact;
    contact.point = Vec3(ball.x * size.x() / 2, -size.y() / 2, ball.z * size.z() / 2);
    contact.normal = contact.impulse = Vec3::UnitY();
    contact.approach_m_s = ball.speed_m_s;
    contact.partner_radius_m = ball.radius_m;
    contact.partner_youngs_modulus_pa = ball.youngs_modulus_pa;
    contact.partner_poisson_ratio = 0.3;
    return {{contact}, {Mobility::ofPoint(ball.mass_kg)}};
}

std::shared_ptr<const BreakableSolid> solidOf(const Body& body, const Settings& settings) {
    return valueOrExit(
        BreakableSolid::make(shapes::slab(body.size, 12, 2, 12), unbreakable(body.material), settings));
}

BlowDamage decided(const BreakableSolid& solid, const Blow& blow) {
    StageTimes ms;
    const auto sampled = valueOrExit(solid.discretisation());
    BlowDamage found =
        blowDamage({solid, *sampled, solid.settings().fracture, 1}, blow, solid.strength(), ms);
    if (found.add_ringing) found.add_ringing(found);
    return found;
}

/// The largest principal stress of a field, anywhere, and away from a place.
struct Largest {
    double pa = 0, away_pa = 0;

    void add(const StressField& field, const Discretisation& solid, const std::vector<Vec3>& places,
             const std::function<bool(const Vec3&)>& is_away) {
        const auto take = [&](const SymmetricTensor& stress, const Vec3& x) {
            const double tension = largestPrincipal(stress);
            pa = std::max(pa, tension);
            if (is_away(x)) away_pa = std::max(away_pa, tension);
        };
        for (std::size_t i = 0; i < field.particles.size(); ++i)
            take(field.particles[i], solid.particles[i].position);
        for (std::size_t i = 0; i < field.surface.size(); ++i)
            take(field.surface[i], solid.surface_points[i].position);
        for (std::size_t i = 0; i < field.points.size(); ++i) take(field.points[i], places[i]);
    }
};

void addTimes(double factor, const StressField& other, StressField& sum) {
    const auto add = [&](const std::vector<SymmetricTensor>& own, std::vector<SymmetricTensor>& all) {
        for (std::size_t i = 0; i < all.size(); ++i) all[i] += factor * own[i];
    };
    add(other.particles, sum.particles);
    add(other.surface, sum.surface);
    add(other.points, sum.points);
}

/// A body under a contact, in time.
class Transient {
  public:
    explicit Transient(const BreakableSolid& solid)
        : solid_(solid),
          problem_(valueOrExit(makeSplineProblem(valueOrExit(solid.discretisation()), solid.material(),
                                                 solid.settings().stress.basis, {}, {}))),
          newmark_(problem_) {}

    int unknowns() const { return newmark_.unknowns(); }

    /// The largest stress under that pulse of the force of `forces`, until one period after it.
    Largest largest(const BlowForces& forces, double period_s,
                    const std::function<bool(const Vec3&)>& is_away) const {
        const Discretisation& sampling = *problem_.solid;
        const StressSolver& solver = *valueOrExit(solid_.stressSolver());
        const Eigen::VectorXd unit = valueOrExit(forcesAt(problem_, forces.loads));
        // A spring to the ground that is far softer than the body lets the inertia of all of it balance the
        // force.
        const double slow = 0.003 * 2 * pi / period_s;
        Eigen::VectorXd at_rest;
        if (!valueOrExit(newmark_.shifted(slow * slow))->solve(unit, at_rest)) std::exit(1);
        // What the grid does not see of the contact follows the force at once.
        StressField unseen = valueOrExit(solver.solveContact(forces.contact));
        addTimes(-1, valueOrExit(solver.stressOfUnknowns(at_rest, forces.contact)), unseen);

        std::vector<Vec3> places;
        for (const SurfacePlace& place : forces.contact.places) places.push_back(place.position);

        Largest found;
        Newmark::Motion now(unknowns());
        const double duration = forces.pulse.duration_s;
        const auto force = [&](double t) {
            return t < duration ? forces.pulse.peak_force_n * std::sin(pi * t / duration) : 0;
        };
        const auto go = [&](double step, double until) {
            const auto stepper = valueOrExit(newmark_.stepper(step));
            for (int i = 0; now.time_s < until; ++i) {
                const double f = force(now.time_s + step);
                if (!newmark_.advance(*stepper, step, f * unit, now)) std::exit(1);
                if (i % 2) continue;
                StressField stress = valueOrExit(solver.stressOfUnknowns(now.displacement, forces.contact));
                addTimes(f, unseen, stress);
                found.add(stress, sampling, places, is_away);
            }
        };
        go(duration / 40, std::min(3 * duration, duration + period_s));
        go(std::clamp(period_s / 400, duration / 40, duration / 10), duration + period_s);
        return found;
    }

  private:
    const BreakableSolid& solid_;
    SplineProblem problem_;
    Newmark newmark_;
};

void compare(const Body& body, const std::vector<Ball>& balls, int& within, int& all) {
    const Settings game = Settings::forQuality(Quality::game);
    Settings finer = game;
    finer.sampling.largest_factor_millions *= 3;
    finer.sampling.largest_factor_if_thin_millions *= 3;
    finer.sampling.layers_across_wall *= 2;
    finer.sampling.largest_count *= 4;
    const auto prepared = solidOf(body, game), unprepared = solidOf(body, game), fine = solidOf(body, finer);
    if (!prepared->prepare({}) || !prepared->reducedStress()) std::exit(1);
    const Transient transient(*fine);
    const ReducedModel& model = prepared->reducedStress()->model;
    const StressSolver& solver = *valueOrExit(prepared->stressSolver());
    const auto sampled = valueOrExit(prepared->completeDiscretisation());
    const Discretisation& sampling = *sampled;
    std::printf("| %s: %d unknowns, truth %d | | | | | |\n", body.name.c_str(),
                3 * model.problem().space->function_count, transient.unknowns());
    for (const Ball& ball : balls) {
        const Blow blow = blowOf(ball, body.size);
        const BlowDamage own = decided(*prepared, blow), quasi_static = decided(*unprepared, blow);
        const double period = own.forces.modes.slowestPeriod();
        const Vec3& point = blow.contacts.front().point;
        const auto is_away = [&](const Vec3& x) { return (x - point).norm() > body.size.y(); };
        const Largest truth = transient.largest(own.forces, period, is_away);

        // The same moments once more, read everywhere.
        StageTimes ms;
        const BlowStress unit =
            valueOrExit(blowStress({*prepared, sampling, prepared->settings().fracture, 1}, blow, ms));
        Largest everywhere;
        for (const auto* states : {&unit.pressed, &unit.ringing})
            for (const VibrationState& state : *states)
                everywhere.add(valueOrExit(stressAt(unit, state, solver, model)), sampling, unit.places,
                               is_away);
        const double ratio = own.damage.largest_stress_pa / truth.pa;
        within += std::abs(ratio - 1) <= 0.15;
        ++all;
        const double static_pa = quasi_static.damage.largest_stress_pa;
        std::printf(
            "| %.3g kg, %.3g m/s, %.2g Pa | %.3f | %.2f | %.2f | %.2f | %.2f |\n", ball.mass_kg,
            ball.speed_m_s, ball.youngs_modulus_pa, own.forces.pulse.duration_s / period, ratio,
            everywhere.away_pa / truth.away_pa,
            static_pa * own.forces.pulse.peak_force_n / quasi_static.forces.pulse.peak_force_n / truth.pa,
            static_pa / truth.pa);
        std::fflush(stdout);
    }
}

}  // namespace

int main() {
    std::printf(
        "| ball | contact over slowest period | with vibrations | the same, away from the contact | "
        "quasi-static, the same force | quasi-static, its own |\n|---|---|---|---|---|---|\n");
    constexpr double steel = 2e11, plastic = 3e9, hard_rubber = 1e8, rubber = 3e6;  // Pa
    int within = 0, all = 0;
    compare({"wall", {1.2, 0.08, 0.9}, Material::plaster()},
            {{0, 0, 0.005, 20, 0.005, steel},
             {0.4, 0.3, 0.05, 20, 0.012, steel},
             {0, 0, 0.1, 10, 0.02, steel},
             {0.5, 0.3, 0.3, 10, 0.03, plastic},
             {0, 0, 0.5, 10, 0.03, hard_rubber},
             {0, 0, 5, 4, 0.1, rubber},
             {-0.3, 0.6, 20, 3, 0.2, rubber}},
            within, all);
    compare({"rod", {0.6, 0.024, 0.03}, Material::ceramic()},
            {{0, 0, 0.005, 5, 0.005, steel},
             {0.5, 0, 0.02, 5, 0.01, steel},
             {0.3, 0, 0.05, 5, 0.02, plastic},
             {0, 0, 0.1, 3, 0.03, plastic},
             {0.7, 0, 0.1, 5, 0.03, hard_rubber},
             {0, 0, 0.5, 2, 0.05, rubber}},
            within, all);
    compare({"plate", {0.3, 0.008, 0.24}, Material::glass()},
            {{0, 0, 0.005, 5, 0.005, steel},
             {0.3, -0.4, 0.02, 5, 0.015, plastic},
             {0, 0, 0.05, 3, 0.02, plastic},
             {-0.5, 0.1, 0.05, 5, 0.02, hard_rubber},
             {-0.6, 0.2, 0.05, 3, 0.03, rubber},
             {0, 0, 0.3, 2, 0.05, rubber},
             {0.4, -0.4, 1, 2, 0.08, rubber}},
            within, all);
    std::printf("within 15 %%: %d of %d\n", within, all);
}
