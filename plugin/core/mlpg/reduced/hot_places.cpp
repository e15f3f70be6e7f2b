#include "core/mlpg/reduced/hot_places.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/stress/elasticity.h"

namespace sherd {

namespace {

constexpr Eigen::Index most_vibrations = 24;

using Stresses = std::vector<SymmetricTensor>;

/// Along which it pulls or presses most.
Vec3 strongestAxis(const SymmetricTensor& stress) {
    const Eigen::SelfAdjointEigenSolver<Mat3> spectrum(toMatrix(stress));
    return spectrum.eigenvectors().col(-spectrum.eigenvalues()[0] > spectrum.eigenvalues()[2] ? 0 : 2);
}

std::size_t hottest(const Stresses& stresses) {
    const auto size = [](const SymmetricTensor& stress) { return toMatrix(stress).squaredNorm(); };
    const auto place = std::max_element(
        stresses.begin(), stresses.end(),
        [&](const SymmetricTensor& a, const SymmetricTensor& b) { return size(a) < size(b); });
    return static_cast<std::size_t>(place - stresses.begin());
}

/// Whether two places say the same of all vibrations.
bool areAlike(const Eigen::RowVectorXf& a, const Eigen::RowVectorXf& b) {
    constexpr float alike = 0.98f;
    return std::abs(a.dot(b)) > alike * a.norm() * b.norm();
}

}  // namespace

Eigen::MatrixXf hotPlaces(const ReducedModel& model, const StressOfUnknowns& stress_of) {
    const Eigen::Index all = model.vibrations().rates_rad_s.size(), count = std::min(all, most_vibrations);
    std::vector<Stresses> of_vibration;
    for (Eigen::Index v = 0; v < count; ++v) {
        auto field = stress_of(model.vibration(Eigen::VectorXd::Unit(all, v).array()).cast<double>());
        if (!field) return {};
        Stresses& stresses = of_vibration.emplace_back(std::move(field.value().surface));
        const Stresses& inside = field.value().particles;
        stresses.insert(stresses.end(), inside.begin(), inside.end());
    }
    std::vector<Eigen::RowVectorXf> places;
    for (const Stresses& own : of_vibration) {
        const std::size_t place = hottest(own);
        const Vec3 along = strongestAxis(own[place]);
        Eigen::RowVectorXf row(count);
        for (Eigen::Index v = 0; v < count; ++v)
            row[v] = static_cast<float>(along.dot(toMatrix(of_vibration[v][place]) * along));
        const bool is_known = std::any_of(places.begin(), places.end(),
                                          [&](const auto& other) { return areAlike(row, other); });
        if (row.allFinite() && !is_known) places.push_back(std::move(row));
    }
    Eigen::MatrixXf hot(places.size(), count);
    for (std::size_t p = 0; p < places.size(); ++p) hot.row(static_cast<Eigen::Index>(p)) = places[p];
    return hot;
}

}  // namespace sherd
