#include "core/mlpg/particle_forms/lu_solver.h"

#include <umfpack.h>

#include <mutex>
#include <utility>

namespace sherd {
namespace {

class LuSolver : public SparseSolver {
  public:
    explicit LuSolver(std::shared_ptr<const SparseMatrix> rows) : matrix_(std::move(rows)) {
        umfpack_di_defaults(control_);
    }

    ~LuSolver() override { umfpack_di_free_numeric(&numeric_); }

    LuSolver(const LuSolver&) = delete;
    LuSolver& operator=(const LuSolver&) = delete;

    Status factor() {
        void* symbolic = nullptr;
        const int* starts = matrix_->starts.data();
        const int* indices = matrix_->indices.data();
        const double* values = matrix_->values.data();
        int status = umfpack_di_symbolic(matrix_->size, matrix_->size, starts, indices, values, &symbolic,
                                         control_, info_);
        if (status == UMFPACK_OK)
            status = umfpack_di_numeric(starts, indices, values, symbolic, &numeric_, control_, info_);
        umfpack_di_free_symbolic(&symbolic);
        if (status == UMFPACK_WARNING_singular_matrix)
            return Error{
                "The stiffness matrix is singular; use galerkin test functions, or another particle spacing "
                "or support "
                "radius."};
        if (status != UMFPACK_OK)
            return Error{"The stiffness matrix could not be factored; is there enough memory?"};
        entries_ = static_cast<long long>(info_[UMFPACK_LNZ] + info_[UMFPACK_UNZ]);
        return success();
    }

    using SparseSolver::solve;
    /// UMFPACK reads columns and ours are rows, so it holds A^T: solve with its transpose.
    bool solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const override {
        const std::lock_guard<std::mutex> lock(mutex_);
        x.resize(b.size());
        return umfpack_di_solve(UMFPACK_At, matrix_->starts.data(), matrix_->indices.data(),
                                matrix_->values.data(), x.data(), b.data(), numeric_, control_,
                                info_) == UMFPACK_OK;
    }

    long long factorEntries() const override { return entries_; }
    double reciprocalCondition() const override { return info_[UMFPACK_RCOND]; }

  private:
    std::shared_ptr<const SparseMatrix> matrix_;
    void* numeric_ = nullptr;
    double control_[UMFPACK_CONTROL];
    mutable double info_[UMFPACK_INFO];
    mutable std::mutex mutex_;
    long long entries_ = 0;
};

}  // namespace

Eigen::VectorXd product(const SparseMatrix& rows, const Eigen::VectorXd& x) {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(rows.size);
    for (int row = 0; row < rows.size; ++row)
        for (int k = rows.starts[row]; k < rows.starts[row + 1]; ++k)
            result[row] += rows.values[k] * x[rows.indices[k]];
    return result;
}

Result<std::unique_ptr<SparseSolver>> factorLu(std::shared_ptr<const SparseMatrix> rows) {
    auto solver = std::make_unique<LuSolver>(std::move(rows));
    if (Status status = solver->factor(); !status) return Error{status.error()};
    return std::unique_ptr<SparseSolver>(std::move(solver));
}

}  // namespace sherd
