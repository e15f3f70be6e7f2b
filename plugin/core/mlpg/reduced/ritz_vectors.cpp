#include "core/mlpg/reduced/ritz_vectors.h"

#include <cmath>
#include <vector>

namespace sherd {

namespace {

constexpr int most = 2;
constexpr double least_new = 1e-3;     // of a vector, by energy, that is not one of the others
constexpr double least_square = 1e-4;  // of the largest: what is faster by far is rounding
constexpr double least_share = 2e-3;   // of the static energy; modes are kept in 16 bits
/// Of the fastest known rate. Plates have 0.95 to 1.1, blocks and balls, where the vectors are joined to the
/// known modes by half, 0.5 to 0.7.
constexpr double least_rate = 0.9;

/// Krylov vectors r_0, r_1 .. of K^-1 M, the first of them the static response, each times the square of a
/// rate so that all are of one size, and the moments r_i^T M r_j, which depend on i + j alone.
struct Krylov {
    std::vector<Eigen::VectorXd> vectors;
    std::vector<double> moments;  ///< [i + j], times the square of the rate

    /// The stiffness and the mass of the vectors from the second on.
    Eigen::MatrixXd hankel(int count, int first) const {
        Eigen::MatrixXd matrix(count, count);
        for (int i = 0; i < count; ++i)
            for (int j = 0; j < count; ++j) matrix(i, j) = moments[first + i + j];
        return matrix;
    }
};

/// As many vectors as there are, up to one more than `most`.
Krylov krylovOf(const BeyondModes& body, double rate_rad_s) {
    Krylov krylov;
    Eigen::VectorXd next = body.response;
    for (int i = 0; next.size() > 0 && i <= most; ++i) {
        krylov.vectors.push_back(std::move(next));
        const Eigen::VectorXd& own = krylov.vectors.back();
        const Eigen::VectorXd momentum = rate_rad_s * rate_rad_s * body.momentum_of(own);
        if (i > 0) krylov.moments.push_back(krylov.vectors[i - 1].dot(momentum));
        krylov.moments.push_back(own.dot(momentum));
        next = i < most ? body.response_to(momentum) : Eigen::VectorXd();
    }
    return krylov;
}

}  // namespace

void addRitzVectors(const BeyondModes& body, StruckModes& struck) {
    if (struck.empty() || !(body.energy_share > least_share)) return;
    const double rate = struck.rates_rad_s.maxCoeff();
    const Krylov krylov = krylovOf(body, rate);
    for (int count = static_cast<int>(krylov.vectors.size()) - 1; count > 0; --count) {
        const Eigen::MatrixXd stiffness = krylov.hankel(count, 1), mass = krylov.hankel(count, 2);
        if (!stiffness.allFinite() || !mass.allFinite() || !(stiffness.diagonal().minCoeff() > 0)) continue;
        // So that the first diagonal is 1: the vectors differ in size, and little in direction.
        const Eigen::VectorXd scale = stiffness.diagonal().array().rsqrt();
        const Eigen::MatrixXd scaled = scale.asDiagonal() * stiffness * scale.asDiagonal();
        const Eigen::LLT<Eigen::MatrixXd> factor(scaled);
        const bool are_new = factor.info() == Eigen::Success &&
                             Eigen::MatrixXd(factor.matrixL()).diagonal().minCoeff() > std::sqrt(least_new);
        if (!are_new) continue;
        const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(
            scale.asDiagonal() * mass * scale.asDiagonal(), scaled);
        const Eigen::VectorXd squares = modes.eigenvalues().reverse();  // (rate / w)^2
        if (modes.info() != Eigen::Success || !(squares.minCoeff() > least_square * squares.maxCoeff()))
            continue;
        if (!(least_rate * least_rate * squares.maxCoeff() < 1)) return;
        const Eigen::MatrixXd factors = scale.asDiagonal() * modes.eigenvectors().rowwise().reverse();

        const Eigen::Index known = struck.work.size();
        struck.rates_rad_s.conservativeResize(known + count);
        struck.work.conservativeResize(known + count);
        struck.ritz_vectors.resize(body.response.size(), count);
        for (int m = 0; m < count; ++m) {
            struck.rates_rad_s[known + m] = rate / std::sqrt(squares[m]);
            struck.work[known + m] = stiffness.row(0).dot(factors.col(m)) / squares[m];
            Eigen::VectorXd shape = Eigen::VectorXd::Zero(body.response.size());
            for (int i = 0; i < count; ++i) shape += factors(i, m) * krylov.vectors[i + 1];
            struck.ritz_vectors.col(m) = shape.cast<float>();
        }
        return;
    }
}

}  // namespace sherd
