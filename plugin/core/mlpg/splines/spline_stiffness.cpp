#include "core/mlpg/splines/spline_stiffness.h"

#include <algorithm>

#include "core/mlpg/splines/b_spline.h"
#include "core/mlpg/splines/part_integrals.h"
#include "core/mlpg/splines/part_ties.h"
#include "core/mlpg/splines/stiffness_pattern.h"
#include "core/numerics/parallel_chunks.h"
#include "core/numerics/wide_vectors.h"

namespace sherd {
namespace {

constexpr int batch_size = 32;  // sets of functions whose matrices are held at a time
constexpr int chunk_count = 16;
constexpr int scatter_count = 4;

using Gram = PartIntegrals::Gram;

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

/// The blocks of K that a part adds to between `count` functions: entry (i, j) of block (a, b) at
/// ((3 b + j) count + a) 3 + i, for a >= b. `gram`: of gradients, for i <= j; `springs`: between functions,
/// or empty.
void blocksOf(const Gram& gram, const Eigen::MatrixXd& springs, int count, const Elasticity& elasticity,
              std::vector<double>& blocks) {
    const double lambda = elasticity.lambda_pa, mu = elasticity.mu_pa;
    blocks.resize(static_cast<size_t>(9 * count * count));
    for (int b = 0; b < count; ++b)
        for (int a = b; a < count; ++a) {
            Mat3 g;  // int grad phi_a grad phi_b^T
            for (int j = 0; j < 3; ++j)
                for (int i = 0; i <= j; ++i) {
                    g(i, j) = gram[3 * i + j](a, b);
                    if (i < j) g(j, i) = gram[3 * i + j](b, a);
                }
            double isotropic = mu * (g(0, 0) + g(1, 1) + g(2, 2));
            if (springs.size() > 0) isotropic += springs(a, b);
            for (int j = 0; j < 3; ++j) {
                double* target = blocks.data() + ((3 * b + j) * count + a) * 3;
                for (int i = 0; i < 3; ++i) target[i] = lambda * g(i, j) + mu * g(j, i);
                target[j] += isotropic;
            }
        }
}

/// Functions that follow each other in a set, and in a column of K.
struct Run {
    int first, count;  ///< in the set
    int row;           ///< of the first, in the column
};

/// Where the functions of a set from `b` on are in the column of b.
void findRuns(const std::vector<int>& functions, int b, const std::vector<int>& rows,
              std::vector<Run>& runs) {
    runs.clear();
    int row = 0;
    for (int a = b; a < static_cast<int>(functions.size()); ++a, ++row) {
        const int before = row;
        while (rows[row] != functions[a]) ++row;
        if (a > b && row == before)
            ++runs.back().count;
        else
            runs.push_back({a, 1, row});
    }
}

SHERD_WIDE_VECTORS void addRuns(const std::vector<Run>& runs, const double* source, double* column) {
    for (const Run& run : runs) {
        const double* from = source + 3L * run.first;
        double* to = column + 3L * run.row;
        for (int i = 0; i < 3 * run.count; ++i) to[i] += from[i];
    }
}

/// Adds a part's blocks to those of K that belong to `functions`, in every `stride`-th column of blocks from
/// `first` on.
void scatter(const std::vector<double>& blocks, const std::vector<int>& functions,
             const StiffnessPattern& pattern, int first, int stride, BlockMatrix& matrix) {
    const int count = static_cast<int>(functions.size());
    std::vector<Run> runs;
    for (int b = 0; b < count; ++b) {
        if (functions[b] % stride != first) continue;
        findRuns(functions, b, pattern.rows_of_column[functions[b]], runs);
        for (int j = 0; j < 3; ++j)
            addRuns(runs, blocks.data() + (3 * b + j) * count * 3, matrix.column(functions[b], j));
    }
}

/// Adds the blocks of sets of functions, `blocks_of(set, storage)`, laid out as in blocksOf.
template <class BlocksOf>
void addBlocks(const std::vector<std::vector<int>>& sets, const StiffnessPattern& pattern,
               const BlocksOf& blocks_of, BlockMatrix& matrix) {
    const int set_count = static_cast<int>(sets.size());
    std::vector<std::vector<double>> storage(batch_size);
    std::vector<const std::vector<double>*> batch(batch_size);
    for (int first = 0; first < set_count; first += batch_size) {
        const int size = std::min(batch_size, set_count - first);
        forEachChunk(chunk_count, [&](int chunk) {
            const int end = chunkBegin(chunk + 1, chunk_count, size);
            for (int n = chunkBegin(chunk, chunk_count, size); n < end; ++n)
                batch[n] = &blocks_of(first + n, storage[n]);
        });
        // A column takes what the sets add in their order, whichever core it is on.
        forEachChunk(scatter_count, [&](int scattered) {
            for (int n = 0; n < size; ++n)
                scatter(*batch[n], sets[first + n], pattern, scattered, scatter_count, matrix);
        });
    }
}

/// Whether a part's own functions all carry unknowns, in ascending order.
bool isUntied(const SplineSpace& space, int part, const std::vector<int>& functions) {
    if (static_cast<int>(functions.size()) != space.perPart()) return false;
    for (int a = 0; a < space.perPart(); ++a) {
        const SplineSpace::Terms terms = space.termsOf(space.raw_of[part][a]);
        if (terms.end() - terms.begin() != 1 || terms.begin()->factor != 1 ||
            terms.begin()->function != functions[a])
            return false;
    }
    return true;
}

/// The blocks of K that a macro cell adds to between its unknown functions, laid out as in blocksOf:
/// lambda times the sum over modes of their rates, c_k for coefficient (a, i) times that for (b, j).
void blocksOf(const VolumetricProjection::MacroCell& cell, const SplineSpace& space,
              const std::vector<int>& functions, double lambda_pa, std::vector<double>& blocks) {
    const auto count = static_cast<long>(functions.size());
    Eigen::MatrixXd rates = Eigen::MatrixXd::Zero(cell.rates.rows(), 3 * count);
    for (size_t f = 0; f < cell.functions.size(); ++f)
        for (const SplineTies::Term& term : space.termsOf(cell.functions[f])) {
            const auto place = std::lower_bound(functions.begin(), functions.end(), term.function);
            rates.middleCols<3>(3 * (place - functions.begin())) +=
                term.factor * cell.rates.middleCols<3>(3L * static_cast<long>(f));
        }
    blocks.resize(static_cast<size_t>(9 * count * count));
    Eigen::Map<Eigen::MatrixXd>(blocks.data(), 3 * count, 3 * count).noalias() =
        lambda_pa * rates.transpose() * rates;
}

}  // namespace

BlockMatrix splineStiffness(const CellParts& solid, const SplineSpace& space, const Elasticity& elasticity,
                            const std::vector<PointSpring>& springs, const VolumetricProjection* projection,
                            const std::vector<double>& share_of_part) {
    const int part_count = static_cast<int>(solid.parts.size());
    std::vector<std::vector<int>> springs_of(part_count);
    for (size_t s = 0; s < springs.size(); ++s) springs_of[springs[s].part].push_back(static_cast<int>(s));

    const StiffnessPattern pattern(space, projection);
    BlockMatrix matrix = emptyMatrixOf(pattern);
    matrix.setZero();
    const PartIntegrals integrals(space.degree, solid.edges);
    const Elasticity by_parts = projection ? withoutLambda(elasticity) : elasticity;
    std::vector<double> whole;
    blocksOf(integrals.wholeCell(), {}, space.perPart(), by_parts, whole);
    const auto blocks_of_part = [&](int part, std::vector<double>& blocks) -> const std::vector<double>& {
        const std::vector<int>& functions = pattern.functions_of_part[part];
        if (solid.parts[part].moments.empty() && share_of_part.empty() && springs_of[part].empty() &&
            isUntied(space, part, functions))
            return whole;
        Gram gram = integrals.gradientProducts(solid.parts[part]);
        const PartTies ties(space, part, functions);
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i <= j; ++i) {
                if (!share_of_part.empty()) gram[3 * i + j] *= share_of_part[part];
                ties.apply(gram[3 * i + j]);
            }
        Eigen::MatrixXd hold;
        if (!springs_of[part].empty()) {
            hold = springMatrix(space, springs, springs_of[part]);
            ties.apply(hold);
        }
        blocksOf(gram, hold, static_cast<int>(functions.size()), by_parts, blocks);
        return blocks;
    };
    addBlocks(pattern.functions_of_part, pattern, blocks_of_part, matrix);
    if (!projection) return matrix;
    const auto blocks_of_macro_cell = [&](int cell,
                                          std::vector<double>& blocks) -> const std::vector<double>& {
        blocksOf(projection->cells()[cell], space, pattern.functions_of_macro_cell[cell],
                 elasticity.lambda_pa, blocks);
        return blocks;
    };
    addBlocks(pattern.functions_of_macro_cell, pattern, blocks_of_macro_cell, matrix);
    return matrix;
}

}  // namespace sherd
