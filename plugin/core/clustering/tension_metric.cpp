#include "core/clustering/tension_metric.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/clustering/penalty_distance.h"
#include "core/stress/elasticity.h"

namespace sherd {

namespace {

constexpr double floor_stretch = 0.15;  // of a distance across all tension, relative to one along the largest
constexpr double finest = 1.0;  // pieces, in particle spacings: dust at the contact is of single particles
constexpr double highest_overstress = 3;  // right under a contact the stress is that of the load's patch

/// Principal values (max(s, 0) / largest * overstress)^4, in the plane of the wall where its axis is known.
Mat3 stretchOf(const SymmetricTensor& stress, const Vec3& axis, double overstress) {
    if (overstress < near_to_failure) return Mat3::Zero();
    Mat3 s = toMatrix(stress);
    if (!axis.isZero(0)) {
        const Mat3 within = Mat3::Identity() - axis * axis.transpose();
        s = within * s * within;
    }
    Eigen::SelfAdjointEigenSolver<Mat3> solver;
    solver.computeDirect(s);
    const double largest = solver.eigenvalues()[2];
    if (!(largest > 0)) return Mat3::Zero();
    const Vec3 relative =
        std::min(overstress, highest_overstress) * (solver.eigenvalues() / largest).cwiseMax(0);
    return solver.eigenvectors() * relative.array().pow(4).matrix().asDiagonal() *
           solver.eigenvectors().transpose();
}

double pieceCount(double volume, double size, double wall) {
    return volume / (size * size * std::min(size, wall));
}

/// How many pieces each particle is if their sizes are in given proportions, in all as many as `wanted`, none
/// finer than the particles.
std::vector<double> pieceCounts(const Discretisation& solid, const std::vector<double>& sizes, int wanted,
                                double wall) {
    const auto countAt = [&](std::size_t i, double scale) {
        const Particle& particle = solid.particles[i];
        return pieceCount(particle.volume, std::max(scale * sizes[i], finest * particle.spacing), wall);
    };
    double low = 1e-6, high = 1e6;
    for (int step = 0; step < 30; ++step) {
        const double scale = std::sqrt(low * high);
        double pieces = 0;
        for (std::size_t i = 0; i < sizes.size(); ++i) pieces += countAt(i, scale);
        (pieces > wanted ? low : high) = scale;
    }
    std::vector<double> counts;
    for (std::size_t i = 0; i < sizes.size(); ++i) counts.push_back(countAt(i, high));
    return counts;
}

}  // namespace

std::vector<TensionMetric> tensionMetrics(const Discretisation& solid, const std::vector<Vec3>& axes,
                                          const Damage& damage, int pieces, double wall_thickness_m,
                                          const GuideField& guide, const BlowAxis& blow) {
    std::vector<TensionMetric> metrics(solid.particles.size());
    std::vector<double> sizes(metrics.size());
    const double wall = wall_thickness_m > 0 ? wall_thickness_m : 1e300;
    for (std::size_t i = 0; i < metrics.size(); ++i) {
        const Vec3& x = solid.particles[i].position;
        Mat3& tensor = metrics[i].tensor;
        tensor = damage.stress.empty() ? Mat3(Mat3::Zero())
                                       : stretchOf(damage.stress[i], axes[i], damage.overstress[i]);
        tensor += floor_stretch * floor_stretch * Mat3::Identity();
        const Mat3 guided = guideStretch(x, guide, blow);
        tensor = guided * tensor * guided;
        const double stress = std::max(damage.overstress[i], near_to_failure);
        double near = 1;
        if (!blow.direction.isZero(0)) near = (x - blow.contact).norm() + blow.radius_m + solid.spacing;
        sizes[i] = near / stress;
    }
    const std::vector<double> counts = pieceCounts(solid, sizes, pieces, wall);
    for (std::size_t i = 0; i < metrics.size(); ++i) metrics[i].pieces = counts[i];
    return metrics;
}

}  // namespace sherd
