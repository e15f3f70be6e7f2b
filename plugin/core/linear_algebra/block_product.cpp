#include "core/linear_algebra/block_product.h"

#include <sherd/types.h>

namespace sherd {

Eigen::VectorXd symmetricBlockProduct(const SparseMatrix& lower, const Eigen::VectorXd& x) {
    // Three columns of blocks at a time: one index for nine entries, and a sum that stays in registers.
    Eigen::VectorXd product = Eigen::VectorXd::Zero(x.size());
    for (int column = 0; column < lower.size; column += 3) {
        const int rows = lower.starts[column + 1] - lower.starts[column];
        const int* row = lower.indices.data() + lower.starts[column];
        const double* value = lower.values.data() + lower.starts[column];
        const Vec3 own = x.segment<3>(column);
        Vec3 sum = Vec3::Zero();
        for (int k = 0; k < rows; k += 3) {
            Mat3 block;
            for (int j = 0; j < 3; ++j) block.col(j) = Eigen::Map<const Vec3>(value + j * rows + k);
            product.segment<3>(row[k]) += block * own;
            if (row[k] > column) sum += block.transpose() * x.segment<3>(row[k]);
        }
        product.segment<3>(column) += sum;
    }
    return product;
}

}  // namespace sherd
