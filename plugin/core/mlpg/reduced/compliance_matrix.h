#pragma once

#include <sherd/result.h>

#include <Eigen/Dense>
#include <vector>

#include "core/linear_algebra/sparse_solver.h"
#include "core/mlpg/splines/spline_problem.h"
#include "core/mlpg/stress_solver.h"

namespace sherd {

/// What a reduced model says of loads.
struct ReducedResponse {
    Eigen::VectorXf unknowns;  ///< displacement, m
    double strain_energy_j = 0;
};

/// What a force on each unknown does to a solid together with the rigid acceleration that balances it: the
/// generalised inverse of the stiffness matrix whose null space is that of the rigid motions. A response is a
/// sum of the columns that are loaded.
struct ComplianceMatrix {
    Eigen::MatrixXf entries;  ///< #unknowns x #unknowns, symmetric, m/N

    /// By a solve a column. An error if the factor cannot be used. `pinned`: unknowns that it holds.
    static Result<ComplianceMatrix> make(const SplineProblem& problem, const SparseSolver& factor,
                                         const std::vector<int>& pinned, const Progress& progress);

    /// Of forces at the unknowns. An error if the displacement is not finite.
    Result<ReducedResponse> respond(const Eigen::VectorXf& forces) const;
};

}  // namespace sherd
