#include "core/linear_algebra/dense_kernels.h"
#include "core/linear_algebra/multifrontal_factor.h"
#include "core/numerics/parallel_chunks.h"

namespace sherd {
namespace {

constexpr int columns_at_once = 192;  // fixed, so that results do not depend on the number of cores

}  // namespace

template <class Number>
Eigen::MatrixXd MultifrontalFactor<Number>::solve(const Eigen::Ref<const Eigen::MatrixXd>& b) const {
    Eigen::MatrixXd result(b.rows(), b.cols());
    const int all = static_cast<int>(b.cols()), chunks = (all + columns_at_once - 1) / columns_at_once;
    forEachChunk(chunks, [&](int chunk) {
        const int first = chunkBegin(chunk, chunks, all), count = chunkBegin(chunk + 1, chunks, all) - first;
        Rows x(b.rows(), count);
        const auto forEachBlock = [&](const auto& visit) {
            for (std::size_t k = 0; k < fronts_.order.size(); ++k)
                visit(x.middleRows(static_cast<long>(k) * block_, block_), 1L * fronts_.order[k] * block_);
        };
        forEachBlock([&](auto&& own, long given) {
            own = b.block(given, first, block_, count).template cast<Number>();
        });
        solveInOrder(x);
        forEachBlock([&](auto&& own, long given) {
            result.block(given, first, block_, count) = own.template cast<double>();
        });
    });
    return result;
}

/// x = L^-T L^-1 x, with rows in the order of the fronts.
template <class Number>
void MultifrontalFactor<Number>::solveInOrder(Rows& x) const {
    const int count = static_cast<int>(x.cols());
    Rows below;  // what a front has to do with below its own rows
    const auto forEachBlock = [&](int front, const auto& visit) {
        long i = 0;
        for (const int row : fronts_.rows[front]) {
            visit(x.middleRows(1L * row * block_, block_), below.middleRows(i, block_));
            i += block_;
        }
    };
    for (int f = 0; f < fronts_.count(); ++f) {
        const int columns = columnCount(f), rows = rowCount(f);
        Number* own = x.row(1L * fronts_.first_column[f] * block_).data();
        solveLower(panel(f), columns, stride(f), false, own, count);
        if (rows == 0) continue;
        below.setZero(rows, count);
        subtractProduct(panel(f) + columns, rows, columns, stride(f), false, own, count, below.data());
        forEachBlock(f, [](auto&& above, auto&& change) { above += change; });
    }
    for (int f = fronts_.count() - 1; f >= 0; --f) {
        const int columns = columnCount(f), rows = rowCount(f);
        Number* own = x.row(1L * fronts_.first_column[f] * block_).data();
        if (rows > 0) {
            below.resize(rows, count);
            forEachBlock(f, [](auto&& above, auto&& copy) { copy = above; });
            subtractProduct(panel(f) + columns, rows, columns, stride(f), true, below.data(), count, own);
        }
        solveLower(panel(f), columns, stride(f), true, own, count);
    }
}

template Eigen::MatrixXd MultifrontalFactor<float>::solve(const Eigen::Ref<const Eigen::MatrixXd>&) const;
template Eigen::MatrixXd MultifrontalFactor<double>::solve(const Eigen::Ref<const Eigen::MatrixXd>&) const;

}  // namespace sherd
