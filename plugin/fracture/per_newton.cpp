#include "fracture/per_newton.h"

#include <algorithm>
#include <cmath>

#include "core/damage/equivalent_bound.h"

namespace sherd {

namespace {

/// The table is read at some hundred places, so that a load between these may do more than it says: in random
/// blows on five bodies the stress was up to 1.6 times and the energy up to 1.1 times what follows from it
/// (tests/benchmark/reduced_model_benchmark prints what is left of the factors).
constexpr double stress_safety = 2, energy_safety = 1.5;

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

BlowBound boundOf(const Impact& impact, const PerNewton& strike, const PerNewton& answer, bool is_held,
                  double shortest_s) {
    // Of the least energy that the body takes from the contact. Supports may hold it from giving way, and
    // what the modes take is known about only.
    constexpr double sure = 0.5;
    const double least = is_held ? 0 : sure * 0.5 * strike.work.squaredNorm();
    const double force = contactPulse(impact, least, shortest_s).peak_force_n;
    // U(f + g)^(1/2) <= U(f)^(1/2) + U(g)^(1/2). The softer the body, the more of the blow it stores.
    PerNewton both;
    both.root_compliance = strike.root_compliance + answer.root_compliance;
    const double on_soft_body = contactPulse(impact, both.energy_j(), shortest_s).peak_force_n;
    // The stress is that of the near field and what is left for the grid, which is less than all of it.
    const double of_strike = std::max(stress_safety * strike.stress_pa, strike.stress_pa + strike.near_pa);
    return {force * (of_strike + stress_safety * answer.stress_pa),
            energy_safety * both.energy_j() * on_soft_body * on_soft_body};
}

}  // namespace sherd
