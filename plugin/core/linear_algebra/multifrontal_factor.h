#pragma once

#include <Eigen/Dense>

#include "core/linear_algebra/big_buffer.h"
#include "core/linear_algebra/block_graph.h"
#include "core/linear_algebra/block_matrix.h"
#include "core/linear_algebra/elimination_schedule.h"
#include "core/linear_algebra/front_tree.h"

namespace sherd {

/// Cholesky factor A = L L^T of a symmetric positive definite matrix in blocks, by fronts (Duff and Reid
/// 1983): the dense matrix of a front takes in its entries of A and what the fronts below left behind;
/// eliminating its own columns leaves an update of its other rows for the front above. Fronts that do not
/// depend on each other are eliminated on several cores; the result has the same bits on any number. In
/// single precision (`Number` float) it takes half the time and memory, and solutions are to be refined.
template <class Number>
class MultifrontalFactor {
  public:
    MultifrontalFactor(const BlockGraph& graph, const EliminationTree& tree, int block_size);

    /// A, whose graph is given, plus `shift` on the diagonal. False where that is not positive definite.
    bool factor(const BlockGraph& graph, const BlockMatrix& matrix, double shift);

    /// A^-1 B for the columns of B; many at once take a fraction of the time that they take one by one, since
    /// the factor passes through memory once for dozens.
    Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& b) const;

    long long entries() const { return static_cast<long long>(panel_starts_.back()); }
    /// Of the squared diagonal of L, the smallest entry over the largest; 0 if one is not a positive number.
    double reciprocalCondition() const;
    /// The least of what elimination left of an entry of the diagonal of A, over that entry.
    double smallestPivotShare(const std::vector<double>& diagonal) const;

  private:
    class Elimination;

    using Rows = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

    void solveInOrder(Rows& x) const;

    int rowCount(int front) const { return block_ * static_cast<int>(fronts_.rows[front].size()); }
    int columnCount(int front) const { return block_ * fronts_.columns(front); }
    int stride(int front) const { return block_ * fronts_.height(front); }
    const Number* panel(int front) const { return values_.data() + panel_starts_[front]; }

    int block_;
    FrontTree fronts_;
    EliminationSchedule schedule_;
    std::vector<std::size_t> panel_starts_;  // per front and one more, into `values_`
    BigBuffer<Number> values_;               // per front its columns of L, own rows first
};

}  // namespace sherd
