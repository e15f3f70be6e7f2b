#include "core/mlpg/particle_forms/shape_functions.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/mlpg/particle_forms/centred_fit.h"
#include "core/mlpg/particle_forms/weight_function.h"

namespace sherd {
namespace {

constexpr double widening_step = 1.25;
constexpr int widening_attempts = 4;
// Sum of |phi|: rounding and noise in the data grow by this factor. A good fit has 1 to 4; beyond 16 a wider
// one is better.
constexpr double largest_amplification = 16;
constexpr double smallest_pivot_ratio = 1e-9;

/// Value (row 0) and gradient (rows 1..3) of the basis p = (1, x, y, z [, xx, yy, zz, xy, yz, zx]) at one
/// point.
template <int N>
using BasisRows = Eigen::Matrix<double, 4, N>;

template <int N>
void evaluateBasis(const Vec3& x, BasisRows<N>& rows) {
    rows.setZero();
    rows(0, 0) = 1;
    for (int j = 0; j < 3; ++j) {
        rows(0, 1 + j) = x[j];
        rows(1 + j, 1 + j) = 1;
    }
    if constexpr (N == 10) {
        for (int j = 0; j < 3; ++j) {
            const int k = (j + 1) % 3;
            rows(0, 4 + j) = x[j] * x[j];
            rows(1 + j, 4 + j) = 2 * x[j];
            rows(0, 7 + j) = x[j] * x[k];
            rows(1 + j, 7 + j) = x[k];
            rows(1 + k, 7 + j) = x[j];
        }
    }
}

}  // namespace

ShapeEvaluator::ShapeEvaluator(const Discretisation& solid, const SupportGraph& supports,
                               const TrialSpace& space)
    : solid_(&solid), supports_(&supports), space_(&space) {}

Evaluation ShapeEvaluator::evaluate(const Vec3& x, int owner, bool with_gradients, ShapeFunctions& out) {
    return evaluateBetween(x, owner, owner, with_gradients, out);
}

Evaluation ShapeEvaluator::evaluateBetween(const Vec3& x, int owner, int other, bool with_gradients,
                                           ShapeFunctions& out) {
    scale_ = supports_->supportRadius(owner);
    Evaluation state = Evaluation::regular;
    if (space_->basis == Basis::quadratic) {
        if (widenUntilFit<10>(x, owner, other, with_gradients, state, out)) return state;
        state = Evaluation::reduced;
    }
    if (widenUntilFit<4>(x, owner, other, with_gradients, state, out)) return state;
    fitDeficient(x, with_gradients, out);
    return Evaluation::deficient;
}

template <int N>
bool ShapeEvaluator::widenUntilFit(const Vec3& x, int owner, int other, bool with_gradients,
                                   Evaluation& state, ShapeFunctions& out) {
    // A point that its own particle's support does not reach (a load beside the solid, a sub-domain of odd
    // shape) starts with a support that does.
    const double distance =
        std::min((x - solid_->particles[owner].position).norm() / supports_->supportRadius(owner),
                 (x - solid_->particles[other].position).norm() / supports_->supportRadius(other));
    widening_ = std::max(1.0, 1.1 * distance);
    for (int attempt = 0; attempt <= widening_attempts; ++attempt) {
        if (widening_ > 1 && state == Evaluation::regular) state = Evaluation::widened;
        gatherCandidates(owner, other, widening_);
        if (fit<N>(x, widening_, with_gradients, out)) return true;
        if (attempt < widening_attempts) widening_ *= widening_step;
    }
    return false;
}

void ShapeEvaluator::gatherCandidates(int owner, int other, double widening) {
    candidates_.clear();
    if (widening == 1) {
        const std::vector<int>& first = supports_->candidates(owner);
        if (owner == other) {
            candidates_ = first;
            return;
        }
        const std::vector<int>& second = supports_->candidates(other);
        std::set_intersection(first.begin(), first.end(), second.begin(), second.end(),
                              std::back_inserter(candidates_));
        return;
    }
    candidates_ = supports_->widerCandidates(owner, widening);
    if (owner == other) return;
    const std::vector<int> second = supports_->widerCandidates(other, widening);
    std::vector<int> both;
    std::set_intersection(candidates_.begin(), candidates_.end(), second.begin(), second.end(),
                          std::back_inserter(both));
    candidates_.swap(both);
}

/// phi_a(x) = p(x)^T M^-1 q_a w_a with M = sum_a w_a q_a q_a^T; q_a = p(x_i) for a value, h_i dp/dx_j(x_i)
/// for a gradient. The basis is written about x, so p(x) = (1, 0, ...). Gradients are complete: of p, of M^-1
/// and of w.
template <int N>
bool ShapeEvaluator::fit(const Vec3& x, double widening, bool with_gradients, ShapeFunctions& out) {
    using Vector = Eigen::Matrix<double, N, 1>;
    using Matrix = Eigen::Matrix<double, N, N>;
    const int data = space_->functionsPerParticle();
    BasisRows<N> rows;
    Matrix moment = Matrix::Zero();
    Matrix moment_slopes[3] = {Matrix::Zero(), Matrix::Zero(), Matrix::Zero()};

    out.particles.clear();
    for (int particle : candidates_) {
        const double radius = widening * supports_->supportRadius(particle);
        const Vec3 offset = solid_->particles[particle].position - x;
        const double weight = splineWeight(offset.norm() / radius);
        if (weight <= 0) continue;
        out.particles.push_back(particle);
        evaluateBasis<N>(offset / scale_, rows);
        rows.template bottomRows<3>() *= solid_->particles[particle].spacing / scale_;
        Matrix outer = rows.row(0).transpose() * rows.row(0);
        if (data == 4)
            outer.noalias() += rows.template bottomRows<3>().transpose() * rows.template bottomRows<3>();
        moment += weight * outer;
        if (!with_gradients) continue;
        const Vec3 slope = -splineWeightSlope(offset.norm() / radius) / (radius * radius) * offset;
        for (int j = 0; j < 3; ++j) moment_slopes[j] += slope[j] * outer;
    }
    if (!(moment(0, 0) > 0)) return false;

    const Eigen::LDLT<Matrix> factored(moment);
    const Vector pivots = factored.vectorD();
    if (!(pivots.minCoeff() > smallest_pivot_ratio * pivots.maxCoeff())) return false;
    const Vector value = factored.solve(Vector::Unit(0));
    Vector slopes[3];
    if (with_gradients)
        for (int j = 0; j < 3; ++j)
            slopes[j] = factored.solve(Vector::Unit(1 + j) / scale_ - moment_slopes[j] * value);

    out.values.resize(out.particles.size() * data);
    if (with_gradients) out.gradients.resize(out.values.size());
    double amplification = 0;
    for (size_t n = 0; n < out.particles.size(); ++n) {
        const int particle = out.particles[n];
        const double radius = widening * supports_->supportRadius(particle);
        const Vec3 offset = solid_->particles[particle].position - x;
        const double weight = splineWeight(offset.norm() / radius);
        evaluateBasis<N>(offset / scale_, rows);
        rows.template bottomRows<3>() *= solid_->particles[particle].spacing / scale_;
        const Eigen::Vector4d fitted = rows * value;
        for (int k = 0; k < data; ++k) out.values[n * data + k] = weight * fitted[k];
        amplification += std::abs(weight * fitted[0]);
        if (!with_gradients) continue;
        const Vec3 slope = -splineWeightSlope(offset.norm() / radius) / (radius * radius) * offset;
        for (int k = 0; k < data; ++k)
            for (int j = 0; j < 3; ++j)
                out.gradients[n * data + k][j] = weight * rows.row(k).dot(slopes[j]) + slope[j] * fitted[k];
    }
    return amplification < largest_amplification;
}

/// Values alone fitted by a linear function without slopes across the plane or line of the neighbours.
/// Reached by MLS only: the gradients that GMLS carries determine a linear function at any number of
/// particles.
void ShapeEvaluator::fitDeficient(const Vec3& x, bool with_gradients, ShapeFunctions& out) const {
    const int data = space_->functionsPerParticle();
    const auto weightOf = [&](int particle) {
        const double distance = (solid_->particles[particle].position - x).norm();
        return splineWeight(distance / (widening_ * supports_->supportRadius(particle)));
    };
    CentredFit fit;
    out.particles.clear();
    for (int particle : candidates_) {
        if (weightOf(particle) <= 0) continue;
        out.particles.push_back(particle);
        fit.add(solid_->particles[particle].position, weightOf(particle));
    }
    fit.finish(0.05 * scale_);
    out.values.assign(out.particles.size() * data, 0);
    if (with_gradients) out.gradients.assign(out.values.size(), Vec3::Zero());
    for (size_t n = 0; n < out.particles.size(); ++n) {
        const Vec3& point = solid_->particles[out.particles[n]].position;
        const double weight = weightOf(out.particles[n]);
        out.values[n * data] = fit.factorAt(x, point, weight);
        if (with_gradients) out.gradients[n * data] = fit.slopeFactor(point, weight);
    }
}

}  // namespace sherd
