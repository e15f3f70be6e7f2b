#include "core/mlpg/splines/spline_stiffness.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/mlpg/splines/part_integrals.h"
#include "core/numerics/parallel_chunks.h"

namespace sherd {
namespace {

constexpr int batch_size = 128;  // parts whose matrices are held at a time
constexpr int chunk_count = 16;

/// What one part adds to K between the unknown functions that reach it.
struct PartMatrix {
    std::vector<int> functions;  // ascending
    PartIntegrals::Gram gram;    // of gradients, for i <= j
    Eigen::MatrixXd springs;     // sum over springs k phi_a phi_b; empty if there are none
};

/// The unknown functions that reach a part, ascending.
std::vector<int> functionsOf(const SplineSpace& space, int part) {
    std::vector<int> list;
    for (const int raw : space.raw_of[part])
        for (int k = space.term_starts[raw]; k < space.term_starts[raw + 1]; ++k)
            list.push_back(space.terms[k].function);
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
}

/// Columns of a part's own functions as columns of the unknown ones that they are tied to.
class Ties {
  public:
    Ties(const SplineSpace& space, int part, const std::vector<int>& functions) : count_(functions.size()) {
        const std::vector<int>& raws = space.raw_of[part];
        for (size_t a = 0; a < raws.size(); ++a)
            for (int k = space.term_starts[raws[a]]; k < space.term_starts[raws[a] + 1]; ++k) {
                const auto place =
                    std::lower_bound(functions.begin(), functions.end(), space.terms[k].function);
                terms_.push_back({static_cast<int>(a), static_cast<int>(place - functions.begin()),
                                  space.terms[k].factor});
                trivial_ =
                    trivial_ && terms_.back().own == terms_.back().unknown && space.terms[k].factor == 1;
            }
        trivial_ = trivial_ && functions.size() == raws.size();
    }

    /// T^T matrix T.
    void apply(Eigen::MatrixXd& matrix) const {
        if (trivial_) return;
        matrix = columns(columns(matrix).transpose()).transpose().eval();
    }

  private:
    struct Term {
        int own, unknown;
        double factor;
    };
    Eigen::MatrixXd columns(const Eigen::MatrixXd& matrix) const {
        Eigen::MatrixXd result = Eigen::MatrixXd::Zero(matrix.rows(), static_cast<long>(count_));
        for (const Term& term : terms_) result.col(term.unknown) += term.factor * matrix.col(term.own);
        return result;
    }

    size_t count_;
    bool trivial_ = true;
    std::vector<Term> terms_;
};

/// int sigma(u) grad phi_a dV over a part, 3 x #functions, for its own coefficients u.
Eigen::Matrix3Xd internalForces(const PartIntegrals& integrals, const CellPart& part,
                                const Elasticity& elasticity, const Eigen::Matrix3Xd& u) {
    const PartIntegrals::Gram own =
        part.moments.empty() ? PartIntegrals::Gram{} : integrals.gradientProducts(part);
    const PartIntegrals::Gram& gram = part.moments.empty() ? integrals.wholeCell() : own;
    Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, u.cols());
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i <= j; ++i) {
            const Eigen::MatrixXd& g = gram[3 * i + j];
            forces.row(i) += elasticity.lambda_pa * u.row(j) * g.transpose();
            forces.row(j) += elasticity.mu_pa * u.row(i) * g.transpose();
            if (i == j) {
                forces += elasticity.mu_pa * u * g.transpose();
                continue;
            }
            forces.row(j) += elasticity.lambda_pa * u.row(i) * g;
            forces.row(i) += elasticity.mu_pa * u.row(j) * g;
        }
    return forces;
}

std::vector<std::vector<int>> blockPattern(const SplineSpace& space,
                                           const std::vector<std::vector<int>>& reach) {
    std::vector<std::vector<int>> parts_of(space.function_count), rows(space.function_count);
    for (size_t part = 0; part < reach.size(); ++part)
        for (const int function : reach[part]) parts_of[function].push_back(static_cast<int>(part));
    std::vector<int> seen(space.function_count, -1);
    for (int column = 0; column < space.function_count; ++column) {
        for (const int part : parts_of[column])
            for (const int row : reach[part]) {
                if (row < column || seen[row] == column) continue;
                seen[row] = column;
                rows[column].push_back(row);
            }
        std::sort(rows[column].begin(), rows[column].end());
    }
    return rows;
}

SparseMatrix allocate(const std::vector<std::vector<int>>& pattern) {
    SparseMatrix matrix;
    matrix.size = static_cast<int>(pattern.size()) * 3;
    size_t entries = 0;
    for (const std::vector<int>& rows : pattern) entries += 9 * rows.size();
    matrix.indices.reserve(entries);
    matrix.starts.assign(1, 0);
    for (const std::vector<int>& rows : pattern)
        for (int k = 0; k < 3; ++k) {
            for (const int row : rows)
                for (int i = 0; i < 3; ++i) matrix.indices.push_back(3 * row + i);
            matrix.starts.push_back(static_cast<int>(matrix.indices.size()));
        }
    matrix.values.assign(matrix.indices.size(), 0.0);
    return matrix;
}

void scatter(const PartMatrix& part, const Elasticity& elasticity,
             const std::vector<std::vector<int>>& pattern, SparseMatrix& matrix) {
    const double lambda = elasticity.lambda_pa, mu = elasticity.mu_pa;
    const int count = static_cast<int>(part.functions.size());
    for (int b = 0; b < count; ++b) {
        const std::vector<int>& rows = pattern[part.functions[b]];
        size_t position = 0;
        for (int a = b; a < count; ++a) {
            while (rows[position] != part.functions[a]) ++position;
            double isotropic = mu * (part.gram[0](a, b) + part.gram[4](a, b) + part.gram[8](a, b));
            const auto gram = [&](int i, int j) {
                return i <= j ? part.gram[3 * i + j](a, b) : part.gram[3 * j + i](b, a);
            };
            if (part.springs.size() > 0) isotropic += part.springs(a, b);
            for (int j = 0; j < 3; ++j) {
                double* target =
                    matrix.values.data() + matrix.starts[3 * part.functions[b] + j] + 3 * position;
                for (int i = 0; i < 3; ++i) target[i] += lambda * gram(i, j) + mu * gram(j, i);
                target[j] += isotropic;
            }
        }
    }
}

}  // namespace

std::vector<PointSpring> springsOf(const CellParts& solid, const std::vector<SupportSpring>& supports) {
    std::vector<PointSpring> springs;
    for (const SupportSpring& support : supports) {
        const int part = solid.partAt(support.position);
        if (part >= 0)
            springs.push_back(
                {part, solid.toCell(support.position, solid.parts[part].cell), support.stiffness_n_m});
    }
    return springs;
}

SparseMatrix splineStiffness(const CellParts& solid, const SplineSpace& space, const Elasticity& elasticity,
                             const std::vector<PointSpring>& springs,
                             const std::vector<double>& share_of_part) {
    const int part_count = static_cast<int>(solid.parts.size());
    std::vector<std::vector<int>> reach(part_count);
    for (int part = 0; part < part_count; ++part) reach[part] = functionsOf(space, part);
    std::vector<std::vector<int>> springs_of(springs.empty() ? 0 : part_count);
    for (size_t s = 0; s < springs.size(); ++s) springs_of[springs[s].part].push_back(static_cast<int>(s));

    const std::vector<std::vector<int>> pattern = blockPattern(space, reach);
    SparseMatrix matrix = allocate(pattern);
    const PartIntegrals integrals(space.degree, solid.edges);
    std::vector<PartMatrix> batch(batch_size);
    for (int first = 0; first < part_count; first += batch_size) {
        const int size = std::min(batch_size, part_count - first);
        forEachChunk(chunk_count, [&](int chunk) {
            std::vector<double> values;
            for (int n = chunkBegin(chunk, chunk_count, size); n < chunkBegin(chunk + 1, chunk_count, size);
                 ++n) {
                const int part = first + n;
                PartMatrix& own = batch[n];
                own.functions = reach[part];
                own.gram = integrals.gradientProducts(solid.parts[part]);
                own.springs.resize(0, 0);
                if (!springs.empty() && !springs_of[part].empty()) {
                    own.springs.setZero(space.perPart(), space.perPart());
                    for (const int s : springs_of[part]) {
                        splineValues(space.degree, springs[s].xi, values);
                        const Eigen::Map<const Eigen::VectorXd> phi(values.data(), values.size());
                        own.springs += springs[s].stiffness_n_m * phi * phi.transpose();
                    }
                }
                const Ties ties(space, part, own.functions);
                for (int j = 0; j < 3; ++j)
                    for (int i = 0; i <= j; ++i) {
                        if (!share_of_part.empty()) own.gram[3 * i + j] *= share_of_part[part];
                        ties.apply(own.gram[3 * i + j]);
                    }
                if (own.springs.size() > 0) ties.apply(own.springs);
            }
        });
        for (int n = 0; n < size; ++n) scatter(batch[n], elasticity, pattern, matrix);
    }
    return matrix;
}

SparseMatrix splinePattern(const CellParts& solid, const SplineSpace& space) {
    std::vector<std::vector<int>> reach(solid.parts.size());
    for (size_t part = 0; part < reach.size(); ++part)
        reach[part] = functionsOf(space, static_cast<int>(part));
    SparseMatrix blocks;
    blocks.size = space.function_count;
    blocks.starts.assign(1, 0);
    for (const std::vector<int>& rows : blockPattern(space, reach)) {
        blocks.indices.insert(blocks.indices.end(), rows.begin(), rows.end());
        blocks.starts.push_back(static_cast<int>(blocks.indices.size()));
    }
    return blocks;
}

Eigen::Matrix3Xd splineInternalForces(const CellParts& solid, const SplineSpace& space,
                                      const Elasticity& elasticity, const std::vector<PointSpring>& springs,
                                      const Eigen::Matrix3Xd& displacement) {
    const PartIntegrals integrals(space.degree, solid.edges);
    const int part_count = static_cast<int>(solid.parts.size());
    std::vector<Eigen::Matrix3Xd> own(part_count);
    forEachChunk(chunk_count, [&](int chunk) {
        const int end = chunkBegin(chunk + 1, chunk_count, part_count);
        Eigen::Matrix3Xd u(3, space.perPart());
        for (int p = chunkBegin(chunk, chunk_count, part_count); p < end; ++p) {
            for (int a = 0; a < space.perPart(); ++a) u.col(a) = displacement.col(space.raw_of[p][a]);
            own[p] = internalForces(integrals, solid.parts[p], elasticity, u);
        }
    });
    Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, space.raw_count);
    for (int p = 0; p < part_count; ++p)
        for (int a = 0; a < space.perPart(); ++a) forces.col(space.raw_of[p][a]) += own[p].col(a);
    std::vector<double> values;
    for (const PointSpring& spring : springs) {
        splineValues(space.degree, spring.xi, values);
        const std::vector<int>& functions = space.raw_of[spring.part];
        Vec3 force = Vec3::Zero();
        for (size_t a = 0; a < functions.size(); ++a) force += values[a] * displacement.col(functions[a]);
        force *= spring.stiffness_n_m;
        for (size_t a = 0; a < functions.size(); ++a) forces.col(functions[a]) += values[a] * force;
    }
    return forces;
}

Eigen::Matrix4Xd splineBodyMoments(const CellParts& solid, const SplineSpace& space,
                                   const std::vector<Vec3>& origins) {
    const PartIntegrals integrals(space.degree, solid.edges);
    Eigen::Matrix4Xd raw = Eigen::Matrix4Xd::Zero(4, space.raw_count);
    for (size_t p = 0; p < solid.parts.size(); ++p) {
        const CellPart& part = solid.parts[p];
        const Vec3 middle =
            solid.origin + (part.cell.cast<double>() + Vec3::Constant(0.5)).cwiseProduct(solid.edges);
        const Eigen::Matrix4Xd own = integrals.bodyMoments(part, middle - origins[p]);
        for (int a = 0; a < space.perPart(); ++a) raw.col(space.raw_of[p][a]) += own.col(a);
    }
    return raw;
}

Eigen::VectorXd symmetricProduct(const SparseMatrix& lower, const Eigen::VectorXd& x) {
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
