#include "core/mlpg/splines/spline_stiffness.h"

#include <algorithm>

#include "core/mlpg/splines/b_spline.h"
#include "core/mlpg/splines/part_integrals.h"
#include "core/mlpg/splines/part_ties.h"
#include "core/mlpg/splines/stiffness_pattern.h"
#include "core/numerics/parallel_chunks.h"
#include "core/numerics/unset_vector.h"
#include "core/numerics/wide_vectors.h"

namespace sherd {
namespace {

constexpr int batch_size = 16;  // sets of functions whose matrices are held at a time
constexpr int chunk_count = 16;
constexpr int scatter_count = 4;

using Gram = PartIntegrals::Gram;
using Blocks = UnsetVector<double>;

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

/// Products of the gradients of functions a, one after the other, with those of one function b:
/// products[i][j] has int d_i phi_a d_j phi_b.
using ProductColumns = const double* [3][3];

/// The three columns of K that b has, where it meets the functions a. `springs`: between them and b.
SHERD_WIDE_VECTORS
void blockColumns(const ProductColumns& products, const double* springs, int count, double lambda, double mu,
                  double* const* columns) {
    const double *g00 = products[0][0], *g01 = products[0][1], *g02 = products[0][2];
    const double *g10 = products[1][0], *g11 = products[1][1], *g12 = products[1][2];
    const double *g20 = products[2][0], *g21 = products[2][1], *g22 = products[2][2];
    double *x = columns[0], *y = columns[1], *z = columns[2];
    SHERD_NO_OVERLAP
    for (int a = 0; a < count; ++a) {
        const double isotropic = mu * (g00[a] + g11[a] + g22[a]) + springs[a];
        x[3 * a] = lambda * g00[a] + mu * g00[a] + isotropic;
        x[3 * a + 1] = lambda * g10[a] + mu * g01[a];
        x[3 * a + 2] = lambda * g20[a] + mu * g02[a];
        y[3 * a] = lambda * g01[a] + mu * g10[a];
        y[3 * a + 1] = lambda * g11[a] + mu * g11[a] + isotropic;
        y[3 * a + 2] = lambda * g21[a] + mu * g12[a];
        z[3 * a] = lambda * g02[a] + mu * g20[a];
        z[3 * a + 1] = lambda * g12[a] + mu * g21[a];
        z[3 * a + 2] = lambda * g22[a] + mu * g22[a] + isotropic;
    }
}

/// The blocks of K that a part adds to between `count` functions: entry (i, j) of block (a, b) at
/// ((3 b + j) count + a) 3 + i, for a >= b. `gram`: of gradients, for i <= j; `springs`: between functions,
/// or empty.
void blocksOf(const Gram& gram, const Eigen::MatrixXd& springs, int count, const Elasticity& elasticity,
              Blocks& blocks) {
    const Eigen::MatrixXd turned[3] = {gram[1].transpose(), gram[2].transpose(), gram[5].transpose()};
    const std::vector<double> no_springs(static_cast<std::size_t>(count), 0.0);
    blocks.resize(static_cast<std::size_t>(9 * count * count));
    for (int b = 0; b < count; ++b) {
        const auto column = [&](const Eigen::MatrixXd& matrix) { return matrix.col(b).data() + b; };
        const ProductColumns products = {{column(gram[0]), column(gram[1]), column(gram[2])},
                                         {column(turned[0]), column(gram[4]), column(gram[5])},
                                         {column(turned[1]), column(turned[2]), column(gram[8])}};
        double* columns[3];
        for (int j = 0; j < 3; ++j) columns[j] = blocks.data() + ((3 * b + j) * count + b) * 3;
        blockColumns(products, springs.size() > 0 ? column(springs) : no_springs.data(), count - b,
                     elasticity.lambda_pa, elasticity.mu_pa, columns);
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
void scatter(const Blocks& blocks, const std::vector<int>& functions, const StiffnessPattern& pattern,
             int first, int stride, BlockMatrix& matrix) {
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
    std::vector<Blocks> storage(batch_size);
    std::vector<const Blocks*> batch(batch_size);
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
              const std::vector<int>& functions, double lambda_pa, Blocks& blocks) {
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
    Blocks whole;
    blocksOf(integrals.wholeCell(), {}, space.perPart(), by_parts, whole);
    const auto blocks_of_part = [&](int part, Blocks& blocks) -> const Blocks& {
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
    const auto blocks_of_macro_cell = [&](int cell, Blocks& blocks) -> const Blocks& {
        blocksOf(projection->cells()[cell], space, pattern.functions_of_macro_cell[cell],
                 elasticity.lambda_pa, blocks);
        return blocks;
    };
    addBlocks(pattern.functions_of_macro_cell, pattern, blocks_of_macro_cell, matrix);
    return matrix;
}

}  // namespace sherd
