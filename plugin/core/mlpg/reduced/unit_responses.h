#pragma once

#include <sherd/result.h>

#include <Eigen/Dense>
#include <utility>
#include <vector>

#include "core/linear_algebra/sparse_solver.h"
#include "core/mlpg/reduced/unit_patches.h"
#include "core/mlpg/splines/spline_problem.h"
#include "core/mlpg/stress_solver.h"

namespace sherd {

/// What 1 N does on each of some patches of a solid, in x, y and z: load 3 p + k acts on patch p along axis
/// k. A patch may also be a function, or several.
struct UnitResponses {
    using Load = std::vector<std::pair<int, double>>;  ///< functions, and what 1 N is at each

    std::vector<Load> loads;        ///< per patch
    Eigen::MatrixXd accelerations;  ///< 6 #components x 3 #patches: the rigid ones that balance the loads
    Eigen::MatrixXd displacements;  ///< #unknowns x 3 #patches, without rigid motion, m
};

/// An error if the factor cannot be used. `pinned`: unknowns that the factor holds.
Result<UnitResponses> unitResponses(const SplineProblem& problem, const SparseSolver& factor,
                                    const std::vector<int>& pinned, const std::vector<UnitPatch>& patches,
                                    const Progress& progress = {});
Result<UnitResponses> unitResponses(const SplineProblem& problem, const SparseSolver& factor,
                                    const std::vector<int>& pinned, std::vector<UnitResponses::Load> loads,
                                    const Progress& progress = {});

}  // namespace sherd
