#include "core/mlpg/splines/spline_mass.h"

#include <algorithm>

#include "core/mlpg/splines/part_integrals.h"
#include "core/mlpg/splines/part_ties.h"
#include "core/mlpg/splines/stiffness_pattern.h"
#include "core/numerics/parallel_chunks.h"

namespace sherd {

SparseMatrix splineMass(const CellParts& solid, const SplineSpace& space) {
    const StiffnessPattern pattern(space);
    const BlockMatrix blocks = emptyMatrixOf(pattern);
    SparseMatrix mass{blocks.blockColumns(), blocks.starts, blocks.rows,
                      std::vector<double>(blocks.rows.size(), 0.0)};
    const PartIntegrals integrals(space.degree, solid.edges);
    for (std::size_t part = 0; part < solid.parts.size(); ++part) {
        const std::vector<int>& functions = pattern.functions_of_part[part];
        Eigen::MatrixXd own = integrals.products(solid.parts[part]);
        PartTies(space, static_cast<int>(part), functions).apply(own);
        for (std::size_t b = 0; b < functions.size(); ++b) {
            auto row = mass.indices.begin() + mass.starts[functions[b]];
            const auto end = mass.indices.begin() + mass.starts[functions[b] + 1];
            for (std::size_t a = b; a < functions.size(); ++a) {
                row = std::lower_bound(row, end, functions[a]);
                mass.values[row - mass.indices.begin()] += own(static_cast<long>(a), static_cast<long>(b));
            }
        }
    }
    return mass;
}

Eigen::MatrixXd massProduct(const SparseMatrix& mass, const Eigen::MatrixXd& displacements) {
    const int count = static_cast<int>(displacements.cols());
    Eigen::MatrixXd product = Eigen::MatrixXd::Zero(displacements.rows(), count);
    constexpr int chunk_count = 16;
    forEachChunk(chunk_count, [&](int chunk) {
        for (int j = chunkBegin(chunk, chunk_count, count); j < chunkBegin(chunk + 1, chunk_count, count);
             ++j)
            for (int b = 0; b < mass.size; ++b)
                for (int k = mass.starts[b]; k < mass.starts[b + 1]; ++k) {
                    const long row = 3L * mass.indices[k], column = 3L * b;
                    product.col(j).segment<3>(row) +=
                        mass.values[k] * displacements.col(j).segment<3>(column);
                    if (row != column)
                        product.col(j).segment<3>(column) +=
                            mass.values[k] * displacements.col(j).segment<3>(row);
                }
    });
    return product;
}

}  // namespace sherd
