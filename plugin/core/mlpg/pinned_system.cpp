#include "core/mlpg/pinned_system.h"

#include <cmath>

#include "core/mlpg/pinned_unknowns.h"

namespace sherd {

namespace {

/// Pins unknowns of a matrix as long as it lives.
class WhilePinned {
  public:
    WhilePinned(BlockMatrix& matrix, const std::vector<int>& unknowns)
        : matrix_(matrix), replaced_(pinUnknowns(matrix, unknowns)) {}
    ~WhilePinned() {
        for (const ReplacedValue& replaced : replaced_) matrix_.values[replaced.index] = replaced.value;
    }
    WhilePinned(const WhilePinned&) = delete;
    WhilePinned& operator=(const WhilePinned&) = delete;

  private:
    BlockMatrix& matrix_;
    std::vector<ReplacedValue> replaced_;
};

}  // namespace

PinnedSystem::PinnedSystem(std::unique_ptr<SparseSolver> solver, std::vector<int> pinned)
    : solver_(std::move(solver)), pinned_(std::move(pinned)) {}

Result<PinnedSystem> PinnedSystem::factor(BlockMatrix& stiffness, std::vector<int> pinned,
                                          const std::vector<Eigen::Vector3i>& places, Precision precision) {
    const WhilePinned while_pinned(stiffness, pinned);
    Result<std::unique_ptr<SparseSolver>> solver = factorCholesky(stiffness, places, precision);
    if (!solver) return Error{solver.error()};
    return PinnedSystem(std::move(solver).value(), std::move(pinned));
}

Result<PinnedSystem::Solution> PinnedSystem::solve(const Eigen::VectorXd& forces, const Residual& residual_of,
                                                   double good_residual) const {
    constexpr int largest_refinements = 5;
    Solution best{Eigen::VectorXd::Zero(forces.size()), 0};
    const double scale = forces.norm();
    if (!(scale > 0)) return best;
    best.residual_rel = 1;
    Eigen::VectorXd residual = forces, correction;
    for (int step = 0; step <= largest_refinements && best.residual_rel > good_residual; ++step) {
        for (const int unknown : pinned_) residual[unknown] = 0;
        // Loads and units of any size are the same to single precision.
        const double size = residual.lpNorm<Eigen::Infinity>();
        if (!(size > 0)) break;
        if (!solver_->solve(residual / size, correction))
            return Error{"The stress solve failed in the linear solver."};
        Eigen::VectorXd next = best.unknowns + size * correction;
        residual = residual_of(next);
        const double next_rel = residual.norm() / scale;
        if (!std::isfinite(next_rel)) return Error{"The stress solve came out not finite."};
        if (step > 0 && !(next_rel < best.residual_rel)) break;
        best = {std::move(next), next_rel};
    }
    return best;
}

}  // namespace sherd
