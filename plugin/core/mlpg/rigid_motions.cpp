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

/// Of one part, from its moments.
Moments partMoments(const CellParts& solid, const CellPart& part) {
    const Vec3 middle =
        solid.origin + (part.cell.cast<double>() + Vec3::Constant(0.5)).cwiseProduct(solid.edges);
    const double cell = solid.edges.prod();
    if (part.moments.empty()) {
        const Mat3 second = (solid.edges.cwiseAbs2() / 12).asDiagonal();
        return {cell, middle, cell * second};
    }
    const int n = solid.order + 1;
    const auto moment = [&](int a, int b, int c) { return part.moments[(c * n + b) * n + a]; };
    const double fill = moment(0, 0, 0);
    const Vec3 first = Vec3(moment(1, 0, 0), moment(0, 1, 0), moment(0, 0, 1)) / fill;
    Mat3 second;
    second << moment(2, 0, 0), moment(1, 1, 0), moment(1, 0, 1), moment(1, 1, 0), moment(0, 2, 0),
        moment(0, 1, 1), moment(1, 0, 1), moment(0, 1, 1), moment(0, 0, 2);
    second -= fill * first * first.transpose();
    return {cell * fill, middle + first.cwiseProduct(solid.edges),
            cell * (solid.edges.asDiagonal() * second * solid.edges.asDiagonal())};
}

std::vector<Moments> componentMoments(const CellParts& solid, const SplineSpace& space) {
    std::vector<Moments> sums(space.component_count);
    std::vector<Moments> parts;
    for (size_t p = 0; p < solid.parts.size(); ++p) {
        parts.push_back(partMoments(solid, solid.parts[p]));
        Moments& sum = sums[space.component_of_part[p]];
        sum.volume += parts[p].volume;
        sum.centroid += parts[p].volume * parts[p].centroid;
    }
    for (Moments& sum : sums) sum.centroid /= sum.volume;
    for (size_t p = 0; p < parts.size(); ++p) {
        Moments& sum = sums[space.component_of_part[p]];
        const Vec3 offset = parts[p].centroid - sum.centroid;
        sum.second += parts[p].second + parts[p].volume * offset * offset.transpose();
    }
    return sums;
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

RigidMotions::RigidMotions(const CellParts& solid, const SplineSpace& space)
    : components{space.component, space.component_count},
      moments(componentMoments(solid, space)),
      unknowns_per_particle(3) {
    for (const Moments& m : moments) size.push_back(std::sqrt(m.second.trace() / m.volume));
    coefficients.setZero(3L * space.function_count, 6);
    for (int f = 0; f < space.function_count; ++f)
        coefficients.middleRows<3>(3L * f) = at(space.centres[f], components.of_particle[f]);
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
