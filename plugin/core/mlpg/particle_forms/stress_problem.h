#pragma once

#include <sherd/material.h>
#include <sherd/settings.h>

#include <string>
#include <vector>

#include "core/mlpg/particle_forms/cell_gradients.h"
#include "core/mlpg/rigid_motions.h"
#include "core/stress/elasticity.h"

namespace sherd {

/// What both weak forms on particles need of a body. Refers to a solid that must outlive it.
struct StressProblem {
    const Discretisation& solid;
    double support_radius;  ///< in particle spacings
    Elasticity elasticity;
    TrialSpace space;
    SupportGraph supports;
    RigidMotions motions;
    CellGradients cells;

    StressProblem(const Discretisation& sampled, const Material& material, const StressSettings& settings);
    long unknowns() const { return motions.coefficients.rows(); }
};

/// What limits trust in a problem's results, with the remedy, as sentences.
std::vector<std::string> trustWarnings(const StressProblem& problem, const Material& material);

/// Stresses of the #cells cells, Pa, for unknowns laid out as in TrialSpace.
std::vector<Mat3> cellStresses(const StressProblem& problem, const Eigen::VectorXd& unknowns);

}  // namespace sherd
