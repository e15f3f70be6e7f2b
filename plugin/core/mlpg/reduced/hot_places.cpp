#include "core/mlpg/reduced/hot_places.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
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

/// The stress that vibrations (columns) have at places (rows), each along the direction in which one of them
/// pulls or presses most there.
Eigen::MatrixXf alongStrongest(const std::vector<Stresses>& of_vibration) {
    const auto places = static_cast<Eigen::Index>(of_vibration.front().size());
    Eigen::MatrixXf pa(places, static_cast<Eigen::Index>(of_vibration.size()));
    for (Eigen::Index place = 0; place < places; ++place) {
        const auto at = [&](const Stresses& stresses) { return toMatrix(stresses[place]); };
        const auto strongest = std::max_element(
            of_vibration.begin(), of_vibration.end(),
            [&](const Stresses& a, const Stresses& b) { return at(a).squaredNorm() < at(b).squaredNorm(); });
        const Vec3 along = strongestAxis((*strongest)[place]);
        for (Eigen::Index v = 0; v < pa.cols(); ++v)
            pa(place, v) = static_cast<float>(along.dot(at(of_vibration[v]) * along));
    }
    return pa;
}

/// Rows that matter: somewhere in them is at least half the largest number of its column. The largest one,
/// and then always the one that has most beyond that chosen before which is most like it.
std::vector<Eigen::Index> differentRows(const Eigen::MatrixXf& rows) {
    constexpr float matters = 0.5f, alike = 0.999f;
    const Eigen::RowVectorXf largest = rows.cwiseAbs().colwise().maxCoeff();
    const Eigen::ArrayXf sizes = rows.rowwise().norm().array();
    const Eigen::ArrayXf divisors = sizes.max(std::numeric_limits<float>::min());
    // The largest cosine between a row and one that was chosen; 1 of what does not matter.
    Eigen::ArrayXf likeness(rows.rows());
    for (Eigen::Index row = 0; row < rows.rows(); ++row)
        likeness[row] = (rows.row(row).cwiseAbs().array() >= matters * largest.array()).any() ? 0.0f : 1.0f;
    std::vector<Eigen::Index> chosen;
    while (chosen.size() < std::size_t{VibrationModes::most_hot_places}) {
        Eigen::Index next = 0;
        const float beyond = (sizes * (1 - likeness.square()).max(0.0f).sqrt()).maxCoeff(&next);
        if (!(beyond > 0) || likeness[next] > alike) break;
        chosen.push_back(next);
        const Eigen::VectorXf products = rows * rows.row(next).transpose();
        likeness = likeness.max(products.array().abs() / (divisors * divisors[next]));
    }
    return chosen;
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
    if (of_vibration.empty() || of_vibration.front().empty()) return {};
    Eigen::MatrixXf all_places = alongStrongest(of_vibration);
    for (auto row : all_places.rowwise())
        if (!row.allFinite()) row.setZero();
    const std::vector<Eigen::Index> chosen = differentRows(all_places);
    Eigen::MatrixXf hot(static_cast<Eigen::Index>(chosen.size()), count);
    for (std::size_t p = 0; p < chosen.size(); ++p)
        hot.row(static_cast<Eigen::Index>(p)) = all_places.row(chosen[p]);
    return hot;
}

}  // namespace sherd
