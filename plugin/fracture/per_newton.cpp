#include "fracture/per_newton.h"

#include <algorithm>
#include <cmath>

#include "core/damage/equivalent_bound.h"
#include "core/numerics/pi.h"
#include "core/vibration/modal_impact.h"

namespace sherd {

namespace {

/// The table is read at some hundred places, so that a load between these may do more than it says: in random
/// blows on five bodies the stress was up to 1.6 times and the energy up to 1.1 times what follows from it
/// (tests/benchmark/reduced_model_benchmark prints what is left of the factors).
constexpr double stress_safety = 2, energy_safety = 1.5;

/// By how much vibrations go beyond the static answer to a contact that is `periods` of the slowest long at
/// most. To a short one most of what bends a body statically does not answer. Rods and plates that are struck
/// for about one period swing up to 1.45 times as far, and longer contacts are followed ever more closely.
double overshoot(double periods) {
    constexpr double is_short = 0.25, medium = 0.6, most = 1.5;
    const double rise = 1 + (most - 1) * (periods - is_short) / (medium - is_short);
    return std::max(1.0, std::min({rise, most, 1 + 1 / (2 * periods)}));
}

}  // namespace

PerNewton underForce(const ContactBody& body, const PeakTable& table, const Vec3& place, const Vec3& normal,
                     const Vec3& force, double lateral, double radius_m) {
    const PeakTable::At at(table, {place.cast<float>(), normal.cast<float>(), static_cast<float>(radius_m)});
    const Mat3 mobility = body.mobility.at(place);
    PerNewton found;
    found.stress_pa = at.stress(force.cast<float>());
    if (lateral > 0) found.stress_pa += lateral * at.stressOfAny();
    found.root_compliance = std::sqrt(at.compliance()) * (force.norm() + lateral);
    found.root_mobility = std::sqrt(force.dot(mobility * force)) + lateral * std::sqrt(mobility.trace());
    found.work = at.work(force.cast<float>());
    return found;
}

double nearFieldPeak(const Material& material, const Vec3& inward, const Vec3& traction_pa) {
    // Of ContactDisc, over the traction: a pressure pulls its rim with (1 - 2 nu) / 5 and presses with 1, a
    // sliding traction does both behind and before it with 1.38 at most, at nu = 1/2.
    constexpr double of_sliding = 1.38;
    const double pressure = std::abs(traction_pa.dot(inward));
    const double sliding = (traction_pa - traction_pa.dot(inward) * inward).norm();
    const double pull = (1 - 2 * material.poisson_ratio) / 5;
    const EquivalentBound bound(*failureCriterion(material.failure_criterion), material);
    return bound(-(pressure + of_sliding * sliding), pull * pressure + of_sliding * sliding);
}

double smallestPatch(const ContactBody& body, const ContactSettings& settings) {
    return settings.smallest_patch * body.wall_thickness_m;
}

bool boundAnswer(const PeakTable& table, const std::vector<Support>& supports, double mass_kg,
                 double root_mobility, double share, PerNewton& answer) {
    constexpr double least_part = 0.2;
    Vec3 along = Vec3::Zero();
    for (const Support& support : supports) along += support.push;
    if (!(along.norm() > 0)) return false;
    double part = 1;
    for (const Support& support : supports) part = std::min(part, support.push.dot(along.normalized()));
    if (part < least_part) return false;
    const double sum = share * std::sqrt(mass_kg) * root_mobility / part;

    const PeakTable::Level& level = table.levels.front();
    double stress = 0, compliance = 0;
    const auto include = [&](double more_stress, double more_compliance) {
        stress = std::max(stress, more_stress);
        compliance = std::max(compliance, more_compliance);
    };
    for (const Support& support : supports) {
        const Eigen::Vector3f push = support.push.cast<float>();
        for (const Vec3& contact : support.contacts) {
            const PeakTable::At at(table, {contact.cast<float>(), push, 0});
            include(at.stress(push), at.compliance());
        }
        if (support.contacts.size() < 2) continue;
        const Eigen::AlignedBox3f box(support.box.min().array() - level.reach_m,
                                      support.box.max().array() + level.reach_m);
        for (const PeakTable::Patch& patch : level.patches)
            if (box.contains(patch.middle) && patch.takes(push))
                include(level.peak(patch, push), patch.compliance_m_n);
    }
    answer.stress_pa = sum * stress;
    answer.root_compliance = sum * std::sqrt(compliance);
    return true;
}

double slowestPeriod(const BreakableSolid& solid) {
    const ReducedStress* reduced = solid.reducedStress();
    if (!reduced || reduced->model.vibrations().rates_rad_s.size() == 0) return 0;
    return 2 * pi / reduced->model.vibrations().rates_rad_s[0];
}

BlowBound boundOf(const Impact& impact, const PerNewton& strike, const PerNewton& answer, bool is_held,
                  double period_s, double shortest_s) {
    const double stiff_s = contactPulse(impact, 0, shortest_s).duration_s;
    // Of the least energy that the body takes from the contact. Supports may hold it from giving way, what
    // the modes take is known about only, and a contact of less than `slow` periods does not wait for them:
    // an oscillator has 3/4 of its static answer then when the force is largest.
    constexpr double sure = 0.5, slow = 0.65;
    const bool is_stiff = is_held || stiff_s < slow * period_s;
    const double least = is_stiff ? 0 : sure * 0.5 * strike.work.squaredNorm();
    const double force = contactPulse(impact, least, shortest_s).peak_force_n;
    // U(f + g)^(1/2) <= U(f)^(1/2) + U(g)^(1/2). The softer the body, the more of the blow it stores.
    PerNewton both;
    both.root_compliance = strike.root_compliance + answer.root_compliance;
    const ContactPulse on_soft_body = contactPulse(impact, both.energy_j(), shortest_s);
    const double soft_n = on_soft_body.peak_force_n;
    const double swing = isQuasiStatic(period_s, stiff_s) ? 1 : overshoot(on_soft_body.duration_s / period_s);
    // The stress is that of the near field and what is left for the grid, which is less than all of it.
    const double bent_pa = swing * strike.stress_pa;
    const double of_strike = std::max(stress_safety * bent_pa, bent_pa + strike.near_pa);
    return {force * (of_strike + stress_safety * swing * answer.stress_pa),
            energy_safety * swing * swing * both.energy_j() * soft_n * soft_n};
}

}  // namespace sherd
