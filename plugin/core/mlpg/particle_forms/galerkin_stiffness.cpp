#include "core/mlpg/particle_forms/galerkin_stiffness.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/parallel_chunks.h"

namespace sherd {
namespace {

constexpr int chunk_count = 32;

// Columns of this many particles are multiplied at a time: what lies above the diagonal blocks is wasted, and
// stays small.
constexpr int strip_width = 4;

/// Per sub-domain the particles whose functions reach it, sorted, and the inverse of that table.
struct Reach {
    std::vector<std::vector<int>> particles_of;   // per sub-domain
    std::vector<std::vector<int>> subdomains_of;  // per particle, ascending
};

Reach findReach(const Discretisation& solid, const CellGradients& cells) {
    Reach reach;
    reach.particles_of.resize(solid.particles.size());
    reach.subdomains_of.resize(solid.particles.size());
    for (size_t subdomain = 0; subdomain < solid.particles.size(); ++subdomain) {
        std::vector<int>& list = reach.particles_of[subdomain];
        for (int cell : solid.particle_cells[subdomain])
            list.insert(list.end(), cells.particles.begin() + cells.starts[cell],
                        cells.particles.begin() + cells.starts[cell + 1]);
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
        for (int particle : list) reach.subdomains_of[particle].push_back(static_cast<int>(subdomain));
    }
    return reach;
}

/// Per particle b the particles a >= b that share a sub-domain with it, sorted: the block pattern of K's
/// lower half.
std::vector<std::vector<int>> blockPattern(const Reach& reach) {
    std::vector<std::vector<int>> rows(reach.particles_of.size());
    std::vector<int> seen(reach.particles_of.size(), -1);
    for (int column = 0; column < static_cast<int>(rows.size()); ++column) {
        rows[column].push_back(column);  // even a particle that nothing reaches keeps its diagonal
        seen[column] = column;
        for (int subdomain : reach.subdomains_of[column])
            for (int row : reach.particles_of[subdomain]) {
                if (row < column || seen[row] == column) continue;
                seen[row] = column;
                rows[column].push_back(row);
            }
        std::sort(rows[column].begin(), rows[column].end());
    }
    return rows;
}

/// Adds up the Gram matrix A_ab = sum_c V_c g_ca g_cb^T, which knows no material, for a range of block
/// columns.
class GramAssembly {
  public:
    GramAssembly(const Discretisation& solid, const CellGradients& cells, const Reach& reach,
                 const std::vector<std::vector<int>>& pattern, BlockMatrix& matrix)
        : solid_(solid),
          cells_(cells),
          reach_(reach),
          pattern_(pattern),
          matrix_(matrix),
          block_(3 * cells.functions_per_particle),
          place_(solid.particles.size(), 0) {}

    void addColumns(int begin, int end) {
        std::vector<int> subdomains;
        for (int particle = begin; particle < end; ++particle)
            subdomains.insert(subdomains.end(), reach_.subdomains_of[particle].begin(),
                              reach_.subdomains_of[particle].end());
        std::sort(subdomains.begin(), subdomains.end());
        subdomains.erase(std::unique(subdomains.begin(), subdomains.end()), subdomains.end());
        for (int subdomain : subdomains) {
            const std::vector<int>& local = reach_.particles_of[subdomain];
            const long first = std::lower_bound(local.begin(), local.end(), begin) - local.begin();
            const long last = std::lower_bound(local.begin(), local.end(), end) - local.begin();
            gather(subdomain, local);
            for (long strip = first; strip < last; strip += strip_width)
                addStrip(local, strip, std::min<long>(strip + strip_width, last));
        }
    }

  private:
    /// Row c of `scaled_` is sqrt(V_c) g_c of the sub-domain's cell c, over all functions that reach the
    /// sub-domain.
    void gather(int subdomain, const std::vector<int>& local) {
        const std::vector<int>& subdomain_cells = solid_.particle_cells[subdomain];
        scaled_.setZero(static_cast<long>(subdomain_cells.size()), static_cast<long>(local.size()) * block_);
        for (size_t n = 0; n < local.size(); ++n) place_[local[n]] = static_cast<int>(n);
        for (size_t c = 0; c < subdomain_cells.size(); ++c) {
            const int cell = subdomain_cells[c];
            const double root = std::sqrt(solid_.cells[cell].moments.volume);
            for (int n = cells_.starts[cell]; n < cells_.starts[cell + 1]; ++n) {
                const double* gradient = cells_.gradients.data() + static_cast<long>(n) * block_;
                const long column = static_cast<long>(place_[cells_.particles[n]]) * block_;
                for (int k = 0; k < block_; ++k)
                    scaled_(static_cast<long>(c), column + k) = root * gradient[k];
            }
        }
    }

    void addStrip(const std::vector<int>& local, long begin, long end) {
        const long rows = (static_cast<long>(local.size()) - begin) * block_;
        product_.resize(rows, (end - begin) * block_);
        product_.noalias() =
            scaled_.rightCols(rows).transpose() * scaled_.middleCols(begin * block_, (end - begin) * block_);
        for (long column = begin; column < end; ++column) scatter(local, begin, column);
    }

    /// Adds the part of `product_` that belongs to one block column, from its diagonal block downwards.
    void scatter(const std::vector<int>& local, long strip_begin, long column) {
        const std::vector<int>& rows = pattern_[local[column]];
        size_t position = 0;
        for (size_t n = column; n < local.size(); ++n) {
            while (rows[position] != local[n]) ++position;
            for (int k = 0; k < block_; ++k) {
                double* target = matrix_.column(local[column], k) + position * block_;
                const double* source = &product_((static_cast<long>(n) - strip_begin) * block_,
                                                 (column - strip_begin) * block_ + k);
                for (int i = 0; i < block_; ++i) target[i] += source[i];
            }
        }
    }

    const Discretisation& solid_;
    const CellGradients& cells_;
    const Reach& reach_;
    const std::vector<std::vector<int>>& pattern_;
    BlockMatrix& matrix_;
    int block_;
    std::vector<int> place_;
    Eigen::MatrixXd scaled_, product_;
};

/// K_ab = lambda A_ab + mu A_ab^T + mu tr(A_ab) I, in place, for a range of block columns.
void applyElasticity(BlockMatrix& matrix, const Elasticity& elasticity, int begin, int end) {
    for (int block_column = begin; block_column < end; ++block_column)
        for (int j = 0; j < matrix.block_size; j += 3) {
            const long height = matrix.height(block_column);
            using Columns = Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, 3>>;
            Columns columns(matrix.column(block_column, j), height, 3);
            for (long row = 0; row < height; row += 3) {
                const Mat3 gram = columns.middleRows<3>(row);
                columns.middleRows<3>(row) = elasticity.lambda_pa * gram +
                                             elasticity.mu_pa * gram.transpose() +
                                             elasticity.mu_pa * gram.trace() * Mat3::Identity();
            }
        }
}

}  // namespace

BlockMatrix galerkinStiffness(const Discretisation& solid, const CellGradients& cells,
                              const Elasticity& elasticity) {
    const Reach reach = findReach(solid, cells);
    const std::vector<std::vector<int>> pattern = blockPattern(reach);
    const int particles = static_cast<int>(solid.particles.size());
    BlockMatrix matrix;
    matrix.block_size = 3 * cells.functions_per_particle;
    for (const std::vector<int>& rows : pattern) matrix.addColumn(rows);
    matrix.setZero();
    forEachChunk(chunk_count, [&](int chunk) {
        const int begin = chunkBegin(chunk, chunk_count, particles);
        const int end = chunkBegin(chunk + 1, chunk_count, particles);
        GramAssembly(solid, cells, reach, pattern, matrix).addColumns(begin, end);
        applyElasticity(matrix, elasticity, begin, end);
    });
    return matrix;
}

}  // namespace sherd
