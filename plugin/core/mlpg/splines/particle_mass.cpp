#include "core/mlpg/splines/particle_mass.h"

#include <Eigen/Eigenvalues>

#include "core/mlpg/splines/b_spline.h"

namespace sherd {

namespace {

/// Of what belongs to each particle. A baked asset has no more of a cell's second moments than the diagonal.
std::vector<Moments> particleMoments(const Discretisation& solid) {
    std::vector<Moments> moments(solid.particles.size());
    for (std::size_t i = 0; i < moments.size(); ++i) {
        moments[i].volume = solid.particles[i].volume;
        moments[i].centroid = solid.particles[i].position;
    }
    for (const IntegrationCell& cell : solid.cells) {
        Moments& all = moments[cell.particle];
        const Vec3 offset = cell.moments.centroid - all.centroid;
        all.second += cell.moments.volume * offset * offset.transpose();
        all.second.diagonal() += cell.moments.second.diagonal();
    }
    return moments;
}

}  // namespace

ParticleMass::ParticleMass(const SplineProblem& problem) : problem_(problem) {
    for (const Moments& moments : particleMoments(*problem.solid)) {
        if (!(moments.volume > 0)) continue;
        const Eigen::SelfAdjointEigenSolver<Mat3> spectrum(moments.second / moments.volume);
        const Mat3 reach =
            spectrum.eigenvectors() * spectrum.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
        constexpr int corners = 8;
        const int part = locate(problem.parts(), moments.centroid).part;
        if (part < 0) continue;
        for (int corner = 0; corner < corners; ++corner) {
            const Vec3 signs(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
            points_.push_back(
                {part, problem.density_kg_m3 * moments.volume / corners,
                 problem.parts().toCell(moments.centroid + reach * signs, problem.parts().parts[part].cell)});
        }
    }
}

Eigen::VectorXd ParticleMass::times(const Eigen::VectorXd& displacement) const {
    const SplineSpace& space = *problem_.space;
    const Eigen::Matrix3Xd raw = space.expand(displacement);
    Eigen::Matrix3Xd product = Eigen::Matrix3Xd::Zero(3, space.raw_count);
    std::vector<double> values;
    for (const Point& point : points_) {
        splineValues(space.degree, point.xi, values);
        const std::vector<int>& functions = space.raw_of[point.part];
        Vec3 momentum = Vec3::Zero();
        for (std::size_t a = 0; a < functions.size(); ++a) momentum += values[a] * raw.col(functions[a]);
        momentum *= point.mass_kg;
        for (std::size_t a = 0; a < functions.size(); ++a) product.col(functions[a]) += values[a] * momentum;
    }
    return space.gather(product);
}

}  // namespace sherd
