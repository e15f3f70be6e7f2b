#include "core/damage/damage.h"

#include <algorithm>

#include "core/stress/principal_stresses.h"

namespace sherd {

Damage damagedParticles(const StressField& stress, double scale, const Discretisation& sampling,
                        const Strength& strength, const std::vector<char>& damaged) {
    const std::size_t n = sampling.particles.size();
    std::vector<double> equivalent(n);
    double tension = 0;
    const auto include = [&](std::size_t particle, const SymmetricTensor& s) {
        const PrincipalStresses principal = principalStresses(s);
        equivalent[particle] = std::max(
            equivalent[particle], strength.criterion.equivalent_stress_pa(principal, strength.material));
        tension = std::max(tension, principal.largest);
    };
    for (std::size_t i = 0; i < n; ++i) include(i, stress.particles[i]);
    for (std::size_t q = 0; q < sampling.surface_points.size(); ++q)
        include(sampling.cells[sampling.surface_points[q].cell].particle, stress.surface[q]);

    Damage damage;
    damage.damaged.resize(n);
    damage.overstress.resize(n);
    damage.largest_stress_pa = scale * tension;
    for (std::size_t i = 0; i < n; ++i) {
        damage.overstress[i] = scale / strength.of_particle[i] * equivalent[i];
        damage.damaged[i] = damage.overstress[i] > 1 || (!damaged.empty() && damaged[i]);
        damage.count += damage.damaged[i];
    }
    return damage;
}

}  // namespace sherd
