#include "core/linear_algebra/cholesky_solver.h"

#include "core/linear_algebra/least_fill.h"
#include "core/linear_algebra/multifrontal_factor.h"

namespace sherd {
namespace {

constexpr double smallest_reciprocal_condition = 1e-15;
constexpr double diagonal_shift = 1e-11;
constexpr int shifts = 3;  // that are tried, each a hundred times the one before

const char* const no_order = "The stiffness matrix could not be ordered; is there enough memory?";

double meanDiagonal(const SparseMatrix& lower) {
    double sum = 0;
    for (int column = 0; column < lower.size; ++column)
        for (int k = lower.starts[column]; k < lower.starts[column + 1]; ++k)
            if (lower.indices[k] == column) sum += lower.values[k];
    return sum / std::max(1, lower.size);
}

class CholeskySolver : public SparseSolver {
  public:
    CholeskySolver(const BlockGraph& graph, const EliminationTree& tree, int block_size)
        : factor_(graph, tree, block_size) {}

    Status factor(const BlockGraph& graph, const SparseMatrix& lower) {
        if (tryFactor(graph, lower, 0)) return success();
        shift_ = diagonal_shift;
        for (int attempt = 0; attempt < shifts; ++attempt, shift_ *= 100)
            if (tryFactor(graph, lower, shift_ * meanDiagonal(lower))) return success();
        return Error{
            "The stiffness matrix is singular beyond repair; try another particle spacing or support "
            "radius."};
    }

    bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const override {
        x = factor_.solve(b);
        return true;
    }
    bool solve(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const override {
        x = factor_.solve(b);
        return true;
    }

    long long factorEntries() const override { return factor_.entries(); }
    double reciprocalCondition() const override { return reciprocal_condition_; }
    double relativeShift() const override { return shift_; }

  private:
    bool tryFactor(const BlockGraph& graph, const SparseMatrix& lower, double shift) {
        if (!factor_.factor(graph, lower, shift)) return false;
        reciprocal_condition_ = factor_.reciprocalCondition();
        return reciprocal_condition_ > smallest_reciprocal_condition;
    }

    MultifrontalFactor factor_;
    double reciprocal_condition_ = 0;
    double shift_ = 0;
};

}  // namespace

Result<std::unique_ptr<SparseSolver>> factorCholesky(const SparseMatrix& lower, int block_size,
                                                     const std::vector<Eigen::Vector3i>& places) {
    const BlockGraph graph = blockGraph(lower, block_size);
    const EliminationTree tree = leastFill(graph, places);
    if (static_cast<int>(tree.order.size()) != graph.size()) return Error{no_order};
    auto solver = std::make_unique<CholeskySolver>(graph, tree, block_size);
    if (Status status = solver->factor(graph, lower); !status) return Error{status.error()};
    return std::unique_ptr<SparseSolver>(std::move(solver));
}

Result<double> factorEntriesOf(const SparseMatrix& blocks, int block_size,
                               const std::vector<Eigen::Vector3i>& places) {
    const BlockGraph graph = blockGraph(blocks, 1);
    const EliminationTree tree = leastFill(graph, places);
    if (static_cast<int>(tree.order.size()) != graph.size()) return Error{no_order};
    return tree.blocks() * block_size * block_size;
}

}  // namespace sherd
