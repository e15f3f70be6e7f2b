#include "core/mlpg/rigid_motions.h"

#include <cmath>

namespace sherd {
namespace {

Mat3 crossMatrix(const Vec3& v) {
    Mat3 m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
}

std::vector<Moments> componentMoments(const Discretisation& solid, const Components& components) {
    std::vector<Moments> moments(components.count);
    for (const IntegrationCell& cell : solid.cells) {
        Moments& sum = moments[components.of_particle[cell.particle]];
        sum.volume += cell.moments.volume;
        sum.centroid += cell.moments.volume * cell.moments.centroid;
    }
    for (Moments& sum : moments) sum.centroid /= sum.volume;
    for (const IntegrationCell& cell : solid.cells) {
        Moments& sum = moments[components.of_particle[cell.particle]];
        const Vec3 offset = cell.moments.centroid - sum.centroid;
        sum.second += cell.moments.second + cell.moments.volume * offset * offset.transpose();
    }
    return moments;
}

}  // namespace

RigidMotions::RigidMotions(const Discretisation& solid, const TrialSpace& space)
    : components(connectedComponents(solid)),
      moments(componentMoments(solid, components)),
      unknowns_per_particle(space.unknownsPerParticle()) {
    for (const Moments& m : moments) size.push_back(std::sqrt(m.second.trace() / m.volume));
    coefficients.setZero(static_cast<long>(solid.particles.size()) * unknowns_per_particle, 6);
    for (size_t i = 0; i < solid.particles.size(); ++i) {
        const int component = components.of_particle[i];
        const Particle& particle = solid.particles[i];
        const long row = static_cast<long>(i) * unknowns_per_particle;
        coefficients.middleRows<3>(row) = at(particle.position, component);
        if (unknowns_per_particle == 3) continue;
        // h d(e_k x r)/dx_j = h e_k x e_j
        for (int j = 0; j < 3; ++j)
            coefficients.block<3, 3>(row + 3 + 3 * j, 3) =
                -crossMatrix(Vec3::Unit(j)) * particle.spacing / size[component];
    }
}

Eigen::Matrix<double, 3, 6> RigidMotions::at(const Vec3& x, int component) const {
    Eigen::Matrix<double, 3, 6> motions;
    motions.leftCols<3>().setIdentity();
    motions.rightCols<3>() = -crossMatrix(x - moments[component].centroid) / size[component];
    return motions;
}

Eigen::Matrix<double, 6, Eigen::Dynamic> RigidMotions::resultants(const Eigen::VectorXd& forces) const {
    Eigen::Matrix<double, 6, Eigen::Dynamic> sums;
    sums.setZero(6, components.count);
    for (long unknown = 0; unknown < forces.size(); ++unknown)
        sums.col(componentOfUnknown(unknown)) += forces[unknown] * coefficients.row(unknown).transpose();
    return sums;
}

std::vector<int> unknownsToPin(const RigidMotions& motions) {
    constexpr double smallest_norm = 1e-6;
    Eigen::Matrix<double, Eigen::Dynamic, 6> rest = motions.coefficients;
    std::vector<int> pinned;
    for (int round = 0; round < 6; ++round) {
        std::vector<long> best(motions.components.count, -1);
        for (long unknown = 0; unknown < rest.rows(); ++unknown) {
            long& leader = best[motions.componentOfUnknown(unknown)];
            if (leader < 0 || rest.row(unknown).squaredNorm() > rest.row(leader).squaredNorm())
                leader = unknown;
        }
        std::vector<Eigen::Matrix<double, 6, 1>> directions(best.size(), Eigen::Matrix<double, 6, 1>::Zero());
        for (size_t component = 0; component < best.size(); ++component) {
            const double norm = rest.row(best[component]).norm();
            if (norm < smallest_norm) continue;
            directions[component] = rest.row(best[component]).transpose() / norm;
            pinned.push_back(static_cast<int>(best[component]));
        }
        for (long unknown = 0; unknown < rest.rows(); ++unknown) {
            const auto& direction = directions[motions.componentOfUnknown(unknown)];
            rest.row(unknown) -= rest.row(unknown).dot(direction.transpose()) * direction.transpose();
        }
    }
    return pinned;
}

}  // namespace sherd
