#pragma once

#include <sherd/result.h>

#include <functional>
#include <memory>
#include <vector>

#include "core/linear_algebra/cholesky_solver.h"

namespace sherd {

/// K u = f of the Galerkin form, factored once: unknowns that are pinned at zero remove the rigid motions of
/// free components, and carry no reaction since loads are balanced. The direct solver is chosen here.
class PinnedSystem {
  public:
    /// K is pinned meanwhile, so nobody else may read it; a copy would take a tenth of the time of the
    /// factor. After that it is as before. `places`: see factorCholesky.
    static Result<PinnedSystem> factor(BlockMatrix& stiffness, std::vector<int> pinned,
                                       const std::vector<Eigen::Vector3i>& places = {},
                                       Precision precision = Precision::full);

    struct Solution {
        Eigen::VectorXd unknowns;
        double residual_rel = 0;  ///< |f - K u| / |f|
    };
    /// f - K u with K as it was before any unknown was pinned.
    using Residual = std::function<Eigen::VectorXd(const Eigen::VectorXd& unknowns)>;

    /// Refines u until `residual_rel` is at most `good_residual` or falls no more. That mends what the
    /// factorisation lost to single precision, a shifted diagonal or a bad condition.
    Result<Solution> solve(const Eigen::VectorXd& forces, const Residual& residual_of,
                           double good_residual) const;

    const SparseSolver& solver() const { return *solver_; }
    const std::vector<int>& pinned() const { return pinned_; }

  private:
    PinnedSystem(std::unique_ptr<SparseSolver> solver, std::vector<int> pinned);

    std::unique_ptr<SparseSolver> solver_;
    std::vector<int> pinned_;
};

}  // namespace sherd
