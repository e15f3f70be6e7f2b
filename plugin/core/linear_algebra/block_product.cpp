#include "core/linear_algebra/block_product.h"

#include <sherd/types.h>

namespace sherd {

Eigen::VectorXd blockProduct(const BlockMatrix& matrix, const Eigen::VectorXd& x) {
    Eigen::VectorXd product = Eigen::VectorXd::Zero(x.size());
    for (int column = 0; column < matrix.blockColumns(); ++column) {
        const long height = matrix.height(column);
        const double* value = matrix.column(column, 0);
        const Vec3 own = x.segment<3>(3L * column);
        Vec3 sum = Vec3::Zero();
        for (int k = matrix.starts[column]; k < matrix.starts[column + 1]; ++k, value += 3) {
            const int row = matrix.rows[k];
            Mat3 block;
            for (int j = 0; j < 3; ++j) block.col(j) = Eigen::Map<const Vec3>(value + j * height);
            product.segment<3>(3L * row) += block * own;
            if (row > column) sum += block.transpose() * x.segment<3>(3L * row);
        }
        product.segment<3>(3L * column) += sum;
    }
    return product;
}

}  // namespace sherd
