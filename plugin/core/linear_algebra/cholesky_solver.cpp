#include "core/linear_algebra/cholesky_solver.h"

#include <cholmod.h>

#include <cmath>
#include <mutex>

namespace sherd {
namespace {

constexpr double smallest_reciprocal_condition = 1e-15;
constexpr double diagonal_shift = 1e-11;

/// CHOLMOD's view of a matrix whose arrays live elsewhere.
cholmod_sparse viewOf(int size, const std::vector<int>& starts, const std::vector<int>& indices,
                      const double* values) {
    cholmod_sparse view{};
    view.nrow = view.ncol = static_cast<size_t>(size);
    view.nzmax = indices.size();
    view.p = const_cast<int*>(starts.data());
    view.i = const_cast<int*>(indices.data());
    view.x = const_cast<double*>(values);
    view.stype = -1;
    view.itype = CHOLMOD_INT;
    view.xtype = values ? CHOLMOD_REAL : CHOLMOD_PATTERN;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = 1;
    view.packed = 1;
    return view;
}

cholmod_dense viewOf(const Eigen::VectorXd& vector) {
    cholmod_dense view{};
    view.nrow = view.nzmax = view.d = static_cast<size_t>(vector.size());
    view.ncol = 1;
    view.x = const_cast<double*>(vector.data());
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    return view;
}

double meanDiagonal(const SparseMatrix& lower) {
    double sum = 0;
    for (int column = 0; column < lower.size; ++column)
        for (int k = lower.starts[column]; k < lower.starts[column + 1]; ++k)
            if (lower.indices[k] == column) sum += lower.values[k];
    return sum / std::max(1, lower.size);
}

class CholeskySolver : public SparseSolver {
  public:
    CholeskySolver() {
        cholmod_start(&common_);
        common_.print = 0;
        common_.supernodal = CHOLMOD_SUPERNODAL;
        common_.final_ll = 1;
    }

    ~CholeskySolver() override {
        cholmod_free_dense(&solution_, &common_);
        cholmod_free_dense(&work_a_, &common_);
        cholmod_free_dense(&work_b_, &common_);
        cholmod_free_factor(&factor_, &common_);
        cholmod_finish(&common_);
    }

    CholeskySolver(const CholeskySolver&) = delete;
    CholeskySolver& operator=(const CholeskySolver&) = delete;

    Status factor(const SparseMatrix& lower, int block_size) {
        std::vector<int> order = blockOrder(lower, block_size);
        if (order.empty()) return Error{"The stiffness matrix could not be ordered; is there enough memory?"};
        cholmod_sparse matrix = viewOf(lower.size, lower.starts, lower.indices, lower.values.data());
        common_.nmethods = 1;
        common_.method[0].ordering = CHOLMOD_GIVEN;
        common_.postorder = 1;
        factor_ = cholmod_analyze_p(&matrix, order.data(), nullptr, 0, &common_);
        if (!factor_) return Error{"The stiffness matrix could not be analysed; is there enough memory?"};
        if (tryFactor(matrix, 0)) return success();
        shift_ = diagonal_shift;
        for (int attempt = 0; attempt < 3; ++attempt, shift_ *= 100)
            if (tryFactor(matrix, shift_ * meanDiagonal(lower))) return success();
        return Error{
            "The stiffness matrix is singular beyond repair; try another particle spacing or support "
            "radius."};
    }

    bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const override {
        const std::lock_guard<std::mutex> lock(mutex_);
        cholmod_dense right = viewOf(b);
        if (!cholmod_solve2(CHOLMOD_A, factor_, &right, nullptr, &solution_, nullptr, &work_a_, &work_b_,
                            &common_))
            return false;
        x = Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(solution_->x), b.size());
        return true;
    }

    long long factorEntries() const override { return static_cast<long long>(factor_->xsize); }
    double reciprocalCondition() const override { return reciprocal_condition_; }
    double relativeShift() const override { return shift_; }

  private:
    /// Fill-reducing order of the blocks, spread to the unknowns; empty on failure.
    std::vector<int> blockOrder(const SparseMatrix& lower, int block_size) {
        const int blocks = lower.size / block_size;
        std::vector<int> starts{0}, indices, order;
        for (int block = 0; block < blocks; ++block) {
            const int column = block * block_size;
            for (int k = lower.starts[column]; k < lower.starts[column + 1]; ++k)
                if (lower.indices[k] % block_size == 0) indices.push_back(lower.indices[k] / block_size);
            starts.push_back(static_cast<int>(indices.size()));
        }
        cholmod_sparse pattern = viewOf(blocks, starts, indices, nullptr);
        common_.nmethods = 2;
        common_.method[0].ordering = CHOLMOD_METIS;
        common_.method[1].ordering = CHOLMOD_AMD;
        cholmod_factor* analysed = cholmod_analyze(&pattern, &common_);
        if (!analysed) return order;
        const int* block_order = static_cast<const int*>(analysed->Perm);
        order.reserve(static_cast<size_t>(lower.size));
        for (int k = 0; k < blocks; ++k)
            for (int i = 0; i < block_size; ++i) order.push_back(block_order[k] * block_size + i);
        cholmod_free_factor(&analysed, &common_);
        return order;
    }

    bool tryFactor(cholmod_sparse& matrix, double shift) {
        double beta[2] = {shift, 0};
        if (!cholmod_factorize_p(&matrix, beta, nullptr, 0, factor_, &common_)) return false;
        if (common_.status != CHOLMOD_OK) return false;
        reciprocal_condition_ = cholmod_rcond(factor_, &common_);
        return reciprocal_condition_ > smallest_reciprocal_condition;
    }

    mutable cholmod_common common_;
    cholmod_factor* factor_ = nullptr;
    mutable cholmod_dense *solution_ = nullptr, *work_a_ = nullptr, *work_b_ = nullptr;
    mutable std::mutex mutex_;
    double reciprocal_condition_ = 0;
    double shift_ = 0;
};

}  // namespace

Result<std::unique_ptr<SparseSolver>> factorCholesky(const SparseMatrix& lower, int block_size) {
    auto solver = std::make_unique<CholeskySolver>();
    if (Status status = solver->factor(lower, block_size); !status) return Error{status.error()};
    return std::unique_ptr<SparseSolver>(std::move(solver));
}

Result<double> factorEntriesOf(const SparseMatrix& blocks, int block_size) {
    cholmod_common common;
    cholmod_start(&common);
    common.print = 0;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_METIS;
    cholmod_sparse pattern = viewOf(blocks.size, blocks.starts, blocks.indices, nullptr);
    cholmod_factor* analysed = cholmod_analyze(&pattern, &common);
    const double entries = common.lnz * block_size * block_size;
    const bool done = analysed != nullptr;
    cholmod_free_factor(&analysed, &common);
    cholmod_finish(&common);
    if (!done) return Error{"The stiffness matrix could not be analysed; is there enough memory?"};
    return entries;
}

}  // namespace sherd
