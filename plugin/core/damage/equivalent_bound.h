#pragma once

#include <algorithm>

#include "core/damage/failure_criterion.h"

namespace sherd {

/// An upper bound of the equivalent stress from bounds of the principal stresses. Criteria are convex and
/// proportional to the stress, so that eq(a + b) <= eq(a) + eq(b): of tensions and pressures each.
struct EquivalentBound {
    double of_tension = 0, of_pressure = 0;

    EquivalentBound(const FailureCriterion& criterion, const Material& material) {
        const auto at = [&](const PrincipalStresses& stress) {
            return criterion.equivalent_stress_pa(stress, material);
        };
        of_tension = std::max({0.0, at({1, 0, 0}), at({1, 1, 0}), at({1, 1, 1})});
        of_pressure = std::max({0.0, at({0, 0, -1}), at({0, -1, -1}), at({-1, -1, -1})});
    }
    /// `smallest_pa` <= 0 <= `largest_pa`: no principal stress is beyond these.
    double operator()(double smallest_pa, double largest_pa) const {
        return of_tension * largest_pa - of_pressure * smallest_pa;
    }
};

}  // namespace sherd
