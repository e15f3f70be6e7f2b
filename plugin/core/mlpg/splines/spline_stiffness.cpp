#include "core/mlpg/splines/spline_stiffness.h"

#include "core/mlpg/splines/b_spline.h"
#include "core/mlpg/splines/part_integrals.h"
#include "core/mlpg/splines/part_ties.h"
#include "core/mlpg/splines/stiffness_pattern.h"
#include "core/numerics/parallel_chunks.h"

namespace sherd {
namespace {

constexpr int batch_size = 128;  // parts whose matrices are held at a time
constexpr int chunk_count = 16;

/// What one part adds to K between the unknown functions that reach it.
struct PartMatrix {
    PartIntegrals::Gram gram;  // of gradients, for i <= j
    Eigen::MatrixXd springs;   // sum over springs k phi_a phi_b; empty if there are none
};

/// sum over a part's springs k phi_a phi_b.
Eigen::MatrixXd springMatrix(const SplineSpace& space, const std::vector<PointSpring>& springs,
                             const std::vector<int>& of_part) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(space.perPart(), space.perPart());
    std::vector<double> values;
    for (const int s : of_part) {
        splineValues(space.degree, springs[s].xi, values);
        const Eigen::Map<const Eigen::VectorXd> phi(values.data(), values.size());
        matrix += springs[s].stiffness_n_m * phi * phi.transpose();
    }
    return matrix;
}

/// Adds a part's matrix to those blocks of K that belong to `functions`.
void scatter(const PartMatrix& part, const std::vector<int>& functions, const Elasticity& elasticity,
             const StiffnessPattern& pattern, SparseMatrix& matrix) {
    const double lambda = elasticity.lambda_pa, mu = elasticity.mu_pa;
    const int count = static_cast<int>(functions.size());
    for (int b = 0; b < count; ++b) {
        const std::vector<int>& rows = pattern.rows_of_column[functions[b]];
        size_t position = 0;
        for (int a = b; a < count; ++a) {
            while (rows[position] != functions[a]) ++position;
            double isotropic = mu * (part.gram[0](a, b) + part.gram[4](a, b) + part.gram[8](a, b));
            const auto gram = [&](int i, int j) {
                return i <= j ? part.gram[3 * i + j](a, b) : part.gram[3 * j + i](b, a);
            };
            if (part.springs.size() > 0) isotropic += part.springs(a, b);
            for (int j = 0; j < 3; ++j) {
                double* target = matrix.values.data() + matrix.starts[3 * functions[b] + j] + 3 * position;
                for (int i = 0; i < 3; ++i) target[i] += lambda * gram(i, j) + mu * gram(j, i);
                target[j] += isotropic;
            }
        }
    }
}

}  // namespace

SparseMatrix splineStiffness(const CellParts& solid, const SplineSpace& space, const Elasticity& elasticity,
                             const std::vector<PointSpring>& springs,
                             const std::vector<double>& share_of_part) {
    const int part_count = static_cast<int>(solid.parts.size());
    std::vector<std::vector<int>> springs_of(part_count);
    for (size_t s = 0; s < springs.size(); ++s) springs_of[springs[s].part].push_back(static_cast<int>(s));

    const StiffnessPattern pattern(space);
    SparseMatrix matrix = zeroStiffness(pattern);
    const PartIntegrals integrals(space.degree, solid.edges);
    const auto matrixOf = [&](int part) {
        PartMatrix own;
        own.gram = integrals.gradientProducts(solid.parts[part]);
        const PartTies ties(space, part, pattern.functions_of_part[part]);
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i <= j; ++i) {
                if (!share_of_part.empty()) own.gram[3 * i + j] *= share_of_part[part];
                ties.apply(own.gram[3 * i + j]);
            }
        if (springs_of[part].empty()) return own;
        own.springs = springMatrix(space, springs, springs_of[part]);
        ties.apply(own.springs);
        return own;
    };
    std::vector<PartMatrix> batch(batch_size);
    for (int first = 0; first < part_count; first += batch_size) {
        const int size = std::min(batch_size, part_count - first);
        forEachChunk(chunk_count, [&](int chunk) {
            const int end = chunkBegin(chunk + 1, chunk_count, size);
            for (int n = chunkBegin(chunk, chunk_count, size); n < end; ++n) batch[n] = matrixOf(first + n);
        });
        for (int n = 0; n < size; ++n)
            scatter(batch[n], pattern.functions_of_part[first + n], elasticity, pattern, matrix);
    }
    return matrix;
}

}  // namespace sherd
