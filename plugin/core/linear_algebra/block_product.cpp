#include "core/linear_algebra/block_product.h"

#include <sherd/types.h>

#include <cstring>
#include <vector>

#include "core/numerics/wide_vectors.h"

namespace sherd {

namespace {

SHERD_INLINED void take(const double* numbers, WideDoubles& side_by_side) {
    std::memcpy(&side_by_side, numbers, sizeof(WideDoubles));
}

/// The three scalar columns of a block column, `height` numbers each: product = V own, and sums = V^T x but
/// for the rows of the diagonal block.
SHERD_WIDE_VECTORS
void multiplyColumns(const double* values, long height, const double* own, const double* x, double* product,
                     double* sums) {
    const double *a = values, *b = values + height, *c = values + 2 * height;
    for (long i = 0; i < 3; ++i) product[i] = a[i] * own[0] + b[i] * own[1] + c[i] * own[2];
    WideDoubles of_a = {}, of_b = {}, of_c = {};
    long i = 3;
    for (; i + wide_count <= height; i += wide_count) {
        WideDoubles at_a, at_b, at_c, at_x;
        take(a + i, at_a);
        take(b + i, at_b);
        take(c + i, at_c);
        take(x + i, at_x);
        const WideDoubles sum = at_a * own[0] + at_b * own[1] + at_c * own[2];
        std::memcpy(product + i, &sum, sizeof(sum));
        of_a += at_a * at_x;
        of_b += at_b * at_x;
        of_c += at_c * at_x;
    }
    for (int j = 0; j < 3; ++j) sums[j] = 0;
    for (long l = 0; l < wide_count; ++l) {
        sums[0] += of_a[l];
        sums[1] += of_b[l];
        sums[2] += of_c[l];
    }
    for (; i < height; ++i) {
        product[i] = a[i] * own[0] + b[i] * own[1] + c[i] * own[2];
        sums[0] += a[i] * x[i];
        sums[1] += b[i] * x[i];
        sums[2] += c[i] * x[i];
    }
}

}  // namespace

Eigen::VectorXd blockProduct(const BlockMatrix& matrix, const Eigen::VectorXd& x) {
    Eigen::VectorXd product = Eigen::VectorXd::Zero(x.size());
    std::vector<double> in_rows, of_rows;  // of a block column
    for (int column = 0; column < matrix.blockColumns(); ++column) {
        const int begin = matrix.starts[column], end = matrix.starts[column + 1];
        if (begin == end) continue;
        const long height = matrix.height(column);
        in_rows.resize(static_cast<std::size_t>(height));
        of_rows.resize(static_cast<std::size_t>(height));
        for (int k = begin; k < end; ++k)
            for (int i = 0; i < 3; ++i) in_rows[3 * (k - begin) + i] = x[3L * matrix.rows[k] + i];
        double sums[3];
        multiplyColumns(matrix.column(column, 0), height, x.data() + 3L * column, in_rows.data(),
                        of_rows.data(), sums);
        for (int k = begin; k < end; ++k)
            for (int i = 0; i < 3; ++i) product[3L * matrix.rows[k] + i] += of_rows[3 * (k - begin) + i];
        for (int i = 0; i < 3; ++i) product[3L * column + i] += sums[i];
    }
    return product;
}

}  // namespace sherd
