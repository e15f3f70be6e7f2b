#include "core/damage/damage.h"

#include <algorithm>
#include <utility>

#include "core/damage/equivalent_bound.h"
#include "core/stress/principal_bound.h"
#include "core/stress/principal_stresses.h"

namespace sherd {

namespace {

std::size_t nearestParticle(const Discretisation& sampling, const Vec3& x) {
    const auto nearer = [&](const Particle& a, const Particle& b) {
        return (a.position - x).squaredNorm() < (b.position - x).squaredNorm();
    };
    const auto& all = sampling.particles;
    return static_cast<std::size_t>(std::min_element(all.begin(), all.end(), nearer) - all.begin());
}

}  // namespace

Damage damagedParticles(const StressField& stress, double scale, const Discretisation& sampling,
                        const Strength& strength, const std::vector<char>& damaged,
                        const std::vector<Vec3>& points) {
    const std::size_t n = sampling.particles.size();
    Damage damage;
    damage.damaged = damaged.empty() ? std::vector<char>(n, 0) : damaged;
    damage.overstress.resize(n);
    damage.stress.assign(n, SymmetricTensor::Zero());
    double tension = 0;
    const EquivalentBound bound(strength.criterion, strength.material);
    const auto matters = [&](std::size_t particle, std::size_t point, const SymmetricTensor& s) {
        constexpr double rounding = 1e-12;
        double smallest, largest;
        boundPrincipal(s[0], s[1], s[2], s[3], s[4], s[5], rounding, smallest, largest);
        return !(largest <= tension &&
                 scale * bound(smallest, largest) < damage.overstress[particle] * strength.at_points[point]);
    };
    const auto include = [&](std::size_t particle, std::size_t point, const SymmetricTensor& s) {
        if (!matters(particle, point, s)) return;  // the principal stresses of all take long
        const PrincipalStresses principal = principalStresses(s);
        const double equivalent = strength.criterion.equivalent_stress_pa(principal, strength.material);
        const double overstress = scale / strength.at_points[point] * equivalent;
        if (overstress > damage.overstress[particle]) {
            damage.overstress[particle] = overstress;
            damage.stress[particle] = scale * s;
        }
        tension = std::max(tension, principal.largest);
    };
    for (std::size_t i = 0; i < n; ++i) include(i, i, stress.particles[i]);
    for (std::size_t q = 0; q < sampling.surface_points.size(); ++q)
        include(sampling.cells[sampling.surface_points[q].cell].particle, n + q, stress.surface[q]);
    // Finding what a point counts for takes long: only where that may matter. Its strength is the particle's.
    const double weakest =
        n > 0 ? *std::min_element(strength.at_points.begin(), strength.at_points.end()) : 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const PrincipalStresses principal = principalStresses(stress.points[i]);
        tension = std::max(tension, principal.largest);
        if (!(scale * strength.criterion.equivalent_stress_pa(principal, strength.material) >
              near_to_failure * weakest))
            continue;
        const std::size_t particle = nearestParticle(sampling, points[i]);
        include(particle, particle, stress.points[i]);
    }

    damage.largest_stress_pa = scale * tension;
    for (std::size_t i = 0; i < n; ++i) {
        damage.damaged[i] |= damage.overstress[i] > 1;
        damage.count += damage.damaged[i];
    }
    return damage;
}

void addDamage(Damage more, Damage& sum) {
    if (sum.damaged.empty()) {
        sum = std::move(more);
        return;
    }
    sum.count = 0;
    for (std::size_t i = 0; i < sum.damaged.size(); ++i) {
        sum.damaged[i] = sum.damaged[i] || more.damaged[i];
        sum.count += sum.damaged[i];
        if (more.overstress[i] <= sum.overstress[i]) continue;
        sum.overstress[i] = more.overstress[i];
        sum.stress[i] = more.stress[i];
    }
    sum.largest_stress_pa = std::max(sum.largest_stress_pa, more.largest_stress_pa);
}

}  // namespace sherd
