#include "core/mlpg/spline_stiffness.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/linear_algebra/gauss_legendre.h"
#include "core/linear_algebra/parallel_chunks.h"

namespace sherd {
namespace {

constexpr int batch_size = 128;  // parts whose matrices are held at a time
constexpr int chunk_count = 16;

/// Gram matrices of gradients: gram[3 i + j](a, b) = int d_i phi_a d_j phi_b dV, for i <= j; the rest is transposed.
/// With `mass(a, b)` = sum over springs k phi_a phi_b.
struct PartMatrix {
    std::vector<int> functions;  // ascending
    std::array<Eigen::MatrixXd, 9> gram;
    Eigen::MatrixXd springs;  // empty if there are none
};

/// Integrates products of a cell's functions over parts of the cell. The products are polynomials of degree 2 p a
/// direction; so 2 p + 1 points a direction with weights that integrate all these exactly serve for any part. The
/// weights are signed where the part is not whole, and harmless since the sum is exact.
class PartIntegrator {
  public:
    PartIntegrator(int degree, const Vec3& edges) : points_(2 * degree + 1) {
        const GaussRule rule = gaussLegendre(points_);
        Eigen::MatrixXd powers(points_, points_);
        for (int k = 0; k < points_; ++k)
            for (int q = 0; q < points_; ++q) powers(k, q) = std::pow(rule.points[q], k);
        weights_of_moments_ = powers.inverse();
        const int functions = (degree + 1) * (degree + 1) * (degree + 1), count = points_ * points_ * points_;
        for (Eigen::MatrixXd& g : gradients_) g.resize(count, functions);
        values_.resize(count, functions);
        positions_.resize(3, count);
        std::vector<Vec3> at;
        std::vector<double> values;
        for (int q = 0; q < count; ++q) {
            const Vec3 xi(rule.points[q % points_], rule.points[q / points_ % points_],
                          rule.points[q / points_ / points_]);
            splineGradients(degree, xi, at);
            for (int a = 0; a < functions; ++a)
                for (int d = 0; d < 3; ++d) gradients_[d](q, a) = at[a][d] / edges[d];
            splineValues(degree, xi, values);
            values_.row(q) = Eigen::Map<const Eigen::RowVectorXd>(values.data(), functions);
            positions_.col(q) = xi.cwiseProduct(edges);
        }
        cell_volume_ = edges.prod();
        whole_weights_.resize(count);
        for (int q = 0; q < count; ++q)
            whole_weights_[q] = rule.weights[q % points_] * rule.weights[q / points_ % points_] *
                       rule.weights[q / points_ / points_];
        whole_ = withWeights(whole_weights_);
    }

    std::array<Eigen::MatrixXd, 9> integrate(const CellPart& part) const {
        return part.moments.empty() ? whole_ : withWeights(weightsOf(part.moments));
    }

    /// int phi_a (1, x - c) dV over a part, 4 x #functions; `middle` of the cell from c, m.
    Eigen::Matrix4Xd bodyMoments(const CellPart& part, const Vec3& middle) const {
        const Eigen::VectorXd weights = part.moments.empty() ? whole_weights_ : weightsOf(part.moments);
        Eigen::Matrix4Xd affine(4, weights.size());
        for (long q = 0; q < weights.size(); ++q)
            affine.col(q) << 1, middle + positions_.col(q);
        return affine * (cell_volume_ * weights).asDiagonal() * values_;
    }

    /// int sigma(u) grad phi_a dV over a part, 3 x #functions, for its own coefficients u.
    Eigen::Matrix3Xd internalForces(const CellPart& part, const Elasticity& elasticity, const Eigen::Matrix3Xd& u) const {
        const Eigen::VectorXd weights =
            cell_volume_ * (part.moments.empty() ? whole_weights_ : weightsOf(part.moments));
        Eigen::MatrixX3d slopes[3];  // column i of slopes[j]: du_i/dx_j at the points
        for (int j = 0; j < 3; ++j) slopes[j].noalias() = gradients_[j] * u.transpose();
        for (long q = 0; q < weights.size(); ++q) {
            Mat3 gradient;
            for (int j = 0; j < 3; ++j) gradient.col(j) = slopes[j].row(q).transpose();
            const Mat3 stress = weights[q] * elasticity.stress(gradient);
            for (int j = 0; j < 3; ++j) slopes[j].row(q) = stress.row(j);
        }
        Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, u.cols());
        for (int j = 0; j < 3; ++j) forces.noalias() += slopes[j].transpose() * gradients_[j];
        return forces;
    }

  private:
    /// The inverse of the powers at the points, direction by direction.
    Eigen::VectorXd weightsOf(const std::vector<double>& moments) const {
        Eigen::VectorXd from = Eigen::Map<const Eigen::VectorXd>(moments.data(), moments.size()), to;
        // Each pass turns one index and moves it to the end, so that three passes restore the order.
        for (int pass = 0; pass < 3; ++pass) {
            const Eigen::Map<const Eigen::MatrixXd> in(from.data(), points_, points_ * points_);
            to.resize(from.size());
            Eigen::Map<Eigen::MatrixXd>(to.data(), points_ * points_, points_).noalias() =
                (weights_of_moments_ * in).transpose();
            from.swap(to);
        }
        return from;
    }

    std::array<Eigen::MatrixXd, 9> withWeights(const Eigen::VectorXd& weights) const {
        std::array<Eigen::MatrixXd, 9> gram;
        for (int j = 0; j < 3; ++j) {
            const Eigen::MatrixXd weighted = (cell_volume_ * weights).asDiagonal() * gradients_[j];
            for (int i = 0; i <= j; ++i) gram[3 * i + j].noalias() = gradients_[i].transpose() * weighted;
        }
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < j; ++i) gram[3 * j + i] = gram[3 * i + j].transpose();
        return gram;
    }

    int points_;
    double cell_volume_ = 1;
    Eigen::MatrixXd weights_of_moments_;
    std::array<Eigen::MatrixXd, 3> gradients_;  // #points x #functions, 1/m
    Eigen::MatrixXd values_;                    // #points x #functions
    Eigen::Matrix3Xd positions_;                // from the middle of the cell, m
    Eigen::VectorXd whole_weights_;
    std::array<Eigen::MatrixXd, 9> whole_;
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

/// From a part's own functions to the unknown ones: gram becomes T^T gram T.
void tie(const SplineSpace& space, int part, PartMatrix& matrix) {
    const std::vector<int>& raws = space.raw_of[part];
    Eigen::MatrixXd ties = Eigen::MatrixXd::Zero(raws.size(), matrix.functions.size());
    for (size_t a = 0; a < raws.size(); ++a)
        for (int k = space.term_starts[raws[a]]; k < space.term_starts[raws[a] + 1]; ++k) {
            const auto place = std::lower_bound(matrix.functions.begin(), matrix.functions.end(),
                                                space.terms[k].function);
            ties(a, place - matrix.functions.begin()) += space.terms[k].factor;
        }
    for (Eigen::MatrixXd& gram : matrix.gram) gram = ties.transpose() * gram * ties;
    if (matrix.springs.size() > 0) matrix.springs = ties.transpose() * matrix.springs * ties;
}

std::vector<std::vector<int>> blockPattern(const SplineSpace& space, const std::vector<std::vector<int>>& reach) {
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

void scatter(const PartMatrix& part, const Elasticity& elasticity, const std::vector<std::vector<int>>& pattern,
             SparseMatrix& matrix) {
    const double lambda = elasticity.lambda_pa, mu = elasticity.mu_pa;
    const int count = static_cast<int>(part.functions.size());
    for (int b = 0; b < count; ++b) {
        const std::vector<int>& rows = pattern[part.functions[b]];
        size_t position = 0;
        for (int a = b; a < count; ++a) {
            while (rows[position] != part.functions[a]) ++position;
            double isotropic = mu * (part.gram[0](a, b) + part.gram[4](a, b) + part.gram[8](a, b));
            if (part.springs.size() > 0) isotropic += part.springs(a, b);
            for (int j = 0; j < 3; ++j) {
                double* target = matrix.values.data() + matrix.starts[3 * part.functions[b] + j] + 3 * position;
                for (int i = 0; i < 3; ++i)
                    target[i] += lambda * part.gram[3 * i + j](a, b) + mu * part.gram[3 * j + i](a, b);
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
            springs.push_back({part, solid.toCell(support.position, solid.parts[part].cell), support.stiffness_n_m});
    }
    return springs;
}

SparseMatrix splineStiffness(const CellParts& solid, const SplineSpace& space, const Elasticity& elasticity,
                             const std::vector<PointSpring>& springs) {
    const int part_count = static_cast<int>(solid.parts.size());
    std::vector<std::vector<int>> reach(part_count);
    for (int part = 0; part < part_count; ++part) reach[part] = functionsOf(space, part);
    std::vector<std::vector<int>> springs_of(springs.empty() ? 0 : part_count);
    for (size_t s = 0; s < springs.size(); ++s) springs_of[springs[s].part].push_back(static_cast<int>(s));

    const std::vector<std::vector<int>> pattern = blockPattern(space, reach);
    SparseMatrix matrix = allocate(pattern);
    const PartIntegrator integrator(space.degree, solid.edges);
    std::vector<PartMatrix> batch(batch_size);
    for (int first = 0; first < part_count; first += batch_size) {
        const int size = std::min(batch_size, part_count - first);
        forEachChunk(chunk_count, [&](int chunk) {
            std::vector<double> values;
            for (int n = chunkBegin(chunk, chunk_count, size); n < chunkBegin(chunk + 1, chunk_count, size); ++n) {
                const int part = first + n;
                PartMatrix& own = batch[n];
                own.functions = reach[part];
                own.gram = integrator.integrate(solid.parts[part]);
                own.springs.resize(0, 0);
                if (!springs.empty() && !springs_of[part].empty()) {
                    own.springs.setZero(space.perPart(), space.perPart());
                    for (const int s : springs_of[part]) {
                        splineValues(space.degree, springs[s].xi, values);
                        const Eigen::Map<const Eigen::VectorXd> phi(values.data(), values.size());
                        own.springs += springs[s].stiffness_n_m * phi * phi.transpose();
                    }
                }
                tie(space, part, own);
            }
        });
        for (int n = 0; n < size; ++n) scatter(batch[n], elasticity, pattern, matrix);
    }
    return matrix;
}

Eigen::Matrix3Xd splineInternalForces(const CellParts& solid, const SplineSpace& space, const Elasticity& elasticity,
                                      const std::vector<PointSpring>& springs, const Eigen::Matrix3Xd& displacement) {
    const PartIntegrator integrator(space.degree, solid.edges);
    const int part_count = static_cast<int>(solid.parts.size());
    std::vector<Eigen::Matrix3Xd> own(part_count);
    forEachChunk(chunk_count, [&](int chunk) {
        const int end = chunkBegin(chunk + 1, chunk_count, part_count);
        Eigen::Matrix3Xd u(3, space.perPart());
        for (int p = chunkBegin(chunk, chunk_count, part_count); p < end; ++p) {
            for (int a = 0; a < space.perPart(); ++a) u.col(a) = displacement.col(space.raw_of[p][a]);
            own[p] = integrator.internalForces(solid.parts[p], elasticity, u);
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
    const PartIntegrator integrator(space.degree, solid.edges);
    Eigen::Matrix4Xd raw = Eigen::Matrix4Xd::Zero(4, space.raw_count);
    for (size_t p = 0; p < solid.parts.size(); ++p) {
        const CellPart& part = solid.parts[p];
        const Vec3 middle =
            solid.origin + (part.cell.cast<double>() + Vec3::Constant(0.5)).cwiseProduct(solid.edges);
        const Eigen::Matrix4Xd own = integrator.bodyMoments(part, middle - origins[p]);
        for (int a = 0; a < space.perPart(); ++a) raw.col(space.raw_of[p][a]) += own.col(a);
    }
    return raw;
}

Eigen::VectorXd symmetricProduct(const SparseMatrix& lower, const Eigen::VectorXd& x) {
    Eigen::VectorXd product = Eigen::VectorXd::Zero(x.size());
    for (int column = 0; column < lower.size; ++column)
        for (int k = lower.starts[column]; k < lower.starts[column + 1]; ++k) {
            const int row = lower.indices[k];
            if (row < column) continue;
            product[row] += lower.values[k] * x[column];
            if (row > column) product[column] += lower.values[k] * x[row];
        }
    return product;
}

}  // namespace sherd
