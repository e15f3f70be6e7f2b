#include "core/linear_algebra/cholesky_solver.h"

#include <algorithm>
#include <numeric>
#include <type_traits>

#include "core/linear_algebra/block_product.h"
#include "core/linear_algebra/least_fill.h"
#include "core/linear_algebra/multifrontal_factor.h"

namespace sherd {
namespace {

constexpr double smallest_reciprocal_condition = 1e-15;
constexpr double diagonal_shifts[] = {0, 1e-11, 1e-9, 1e-7};  // that are tried

const char* const no_order = "The stiffness matrix could not be ordered; is there enough memory?";

double meanOf(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) /
           static_cast<double>(std::max<std::size_t>(1, values.size()));
}

template <class Number>
class CholeskySolver : public SparseSolver {
  public:
    CholeskySolver(const BlockGraph& graph, const EliminationTree& tree, int block_size)
        : factor_(graph, tree, block_size) {}

    bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const override {
        x = factor_.solve(b);
        return true;
    }
    bool solve(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const override {
        x = factor_.solve(b);
        return true;
    }

    double smallestPivotShare(const std::vector<double>& diagonal) const {
        return factor_.smallestPivotShare(diagonal);
    }
    long long factorEntries() const override { return factor_.entries(); }
    double reciprocalCondition() const override { return reciprocal_condition_; }
    double relativeShift() const override { return relative_shift_; }
    bool isSingle() const override { return std::is_same_v<Number, float>; }

    /// False where the matrix, with the shift, is not safely positive definite.
    bool factor(const BlockGraph& graph, const BlockMatrix& matrix, double relative_shift) {
        relative_shift_ = relative_shift;
        const double shift = relative_shift > 0 ? relative_shift * meanOf(diagonalOf(matrix)) : 0;
        if (!factor_.factor(graph, matrix, shift)) return false;
        reciprocal_condition_ = factor_.reciprocalCondition();
        return reciprocal_condition_ > smallest_reciprocal_condition;
    }

  private:
    MultifrontalFactor<Number> factor_;
    double reciprocal_condition_ = 0;
    double relative_shift_ = 0;
};

/// Whether refinements get anywhere: no pivot is small enough to be what rounding made of none, and a first
/// one takes enough off the residual of a load that moves the softest motions.
bool isRefinable(const CholeskySolver<float>& solver, const BlockMatrix& matrix) {
    constexpr double smallest_pivot = 3e-6, largest_left = 0.03;
    if (!(solver.smallestPivotShare(diagonalOf(matrix)) > smallest_pivot)) return false;
    const Eigen::VectorXd load = Eigen::VectorXd::Ones(matrix.size());
    Eigen::VectorXd answer;
    if (!solver.solve(load, answer) || !answer.allFinite()) return false;
    return (load - blockProduct(matrix, answer)).norm() <= largest_left * load.norm();
}

}  // namespace

Result<std::unique_ptr<SparseSolver>> factorCholesky(const BlockMatrix& matrix,
                                                     const std::vector<Eigen::Vector3i>& places,
                                                     Precision precision) {
    const BlockGraph graph = blockGraph(matrix.starts, matrix.rows);
    const int block_size = matrix.block_size;
    const EliminationTree tree = leastFill(graph, places);
    if (static_cast<int>(tree.order.size()) != graph.size()) return Error{no_order};
    if (precision == Precision::refined && block_size == 3) {
        auto solver = std::make_unique<CholeskySolver<float>>(graph, tree, block_size);
        if (solver->factor(graph, matrix, 0) && isRefinable(*solver, matrix))
            return std::unique_ptr<SparseSolver>(std::move(solver));
    }
    auto solver = std::make_unique<CholeskySolver<double>>(graph, tree, block_size);
    for (const double shift : diagonal_shifts)
        if (solver->factor(graph, matrix, shift)) return std::unique_ptr<SparseSolver>(std::move(solver));
    return Error{
        "The stiffness matrix is singular beyond repair; try another particle spacing or support radius."};
}

Result<double> factorEntriesOf(const BlockMatrix& pattern, const std::vector<Eigen::Vector3i>& places) {
    const BlockGraph graph = blockGraph(pattern.starts, pattern.rows);
    const EliminationTree tree = leastFill(graph, places);
    if (static_cast<int>(tree.order.size()) != graph.size()) return Error{no_order};
    return tree.blocks() * pattern.block_size * pattern.block_size;
}

}  // namespace sherd
