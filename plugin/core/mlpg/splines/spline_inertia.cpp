#include "core/mlpg/splines/spline_inertia.h"

#include "core/mlpg/splines/body_moments.h"

namespace sherd {

Eigen::Matrix4Xd inertiaMoments(const CellParts& solid, const SplineSpace& space,
                                const RigidMotions& motions) {
    std::vector<Vec3> origins;
    for (const int component : space.component_of_part)
        origins.push_back(motions.moments[component].centroid);
    const Eigen::Matrix4Xd raw = splineBodyMoments(solid, space, origins);
    Eigen::Matrix4Xd sums = Eigen::Matrix4Xd::Zero(4, space.function_count);
    for (int r = 0; r < space.raw_count; ++r)
        for (const SplineTies::Term& term : space.termsOf(r))
            sums.col(term.function) += term.factor * raw.col(r);
    return sums;
}

InertiaRelief splineInertia(const Eigen::Matrix4Xd& moments, const RigidMotions& motions) {
    InertiaRelief::Forces forces = InertiaRelief::Forces::Zero(motions.coefficients.rows(), 6);
    for (long function = 0; function < moments.cols(); ++function) {
        const double size = motions.size[motions.componentOfUnknown(3 * function)];
        const Vec3 first = moments.col(function).tail<3>();
        for (int k = 0; k < 3; ++k) {
            forces(3 * function + k, k) = moments(0, function);
            forces.block<3, 1>(3 * function, 3 + k) = Vec3::Unit(k).cross(first) / size;
        }
    }
    return InertiaRelief(std::move(forces), motions);
}

Mat3 spinForce(const Vec3& w, double density_kg_m3) {
    return -density_kg_m3 * (w * w.transpose() - w.squaredNorm() * Mat3::Identity());
}

double addSpin(const Mat3& spin_force, const Eigen::Matrix4Xd& moments, Eigen::VectorXd& forces) {
    double magnitude = 0;
    for (long f = 0; f < moments.cols(); ++f) {
        const Vec3 force = spin_force * moments.col(f).tail<3>();
        forces.segment<3>(3 * f) += force;
        magnitude += force.norm();
    }
    return magnitude;
}

std::vector<AffineForce> inertiaForces(const SplineSpace& space, const RigidMotions& motions,
                                       const Eigen::Matrix<double, 6, Eigen::Dynamic>& acceleration,
                                       const Mat3& spin_force) {
    std::vector<AffineForce> forces;
    for (const int component : space.component_of_part) {
        AffineForce force;
        const Vec3 angular = acceleration.col(component).tail<3>() / motions.size[component];
        force.value = acceleration.col(component).head<3>();
        for (int j = 0; j < 3; ++j) force.gradient.col(j) = angular.cross(Vec3::Unit(j));
        force.gradient += spin_force;
        force.about = motions.moments[component].centroid;
        forces.push_back(force);
    }
    return forces;
}

}  // namespace sherd
