#pragma once

#include <sherd/material.h>

#include <string>
#include <vector>

#include "core/stress/principal_stresses.h"

namespace sherd {

/// When an isotropic brittle material fails. A criterion holds both its test of a stress and the energy bound
/// by which weak blows are skipped, so that the two cannot disagree. To add one, define it in a file of its
/// own beside this one, and name it in the list in failure_criterion.cpp.
struct FailureCriterion {
    const char* name;

    /// The uniaxial tension that is as near to failure as `stress`, Pa. Where it exceeds the tensile strength
    /// of the place the material fails; below zero it is far from it. Proportional to the stress: all
    /// strengths of a place are in the proportion of the material's. Convex in the stress: bounds of a sum of
    /// loads rest on it (EquivalentBound, PeakTable).
    double (*equivalent_stress_pa)(const PrincipalStresses& stress, const Material& material);

    /// The least elastic energy density of any stress that fails where the tensile strength is
    /// `tensile_strength_pa`, J/m^3.
    double (*least_energy_density_j_m3)(double tensile_strength_pa, const Material& material);
};

/// All criteria, the default first.
const std::vector<const FailureCriterion*>& failureCriteria();

/// The criterion of a name; nullptr if there is none.
const FailureCriterion* failureCriterion(const std::string& name);

}  // namespace sherd
