#include "core/loads/mobility.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

namespace sherd {

Mobility Mobility::of(const Moments& moments, double density_kg_m3) {
    const Mat3 second = density_kg_m3 * moments.second;
    const Mat3 inertia = second.trace() * Mat3::Identity() - second;
    return {moments.centroid, 1 / (density_kg_m3 * moments.volume), inertia.inverse()};
}

Mobility Mobility::ofPoint(double mass_kg, const Vec3& position) {
    return {position, 1 / mass_kg, Mat3::Zero()};
}

Mobility Mobility::heldBack(const Mat3& free_turns) const {
    const Eigen::SelfAdjointEigenSolver<Mat3> axes(free_turns);
    const Mat3 root = axes.eigenvectors() * axes.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal() *
                      axes.eigenvectors().transpose();
    return {centre, inverse_mass, root * inverse_inertia * root};
}

Wrench Mobility::wrench(const Vec3& point, const Vec3& force) const {
    Wrench w;
    w << force, (point - centre).cross(force);
    return w;
}

Wrench Mobility::response(const Wrench& impulse) const {
    Wrench change;
    change << inverse_mass * impulse.head<3>(), inverse_inertia * impulse.tail<3>();
    return change;
}

Mat3 Mobility::at(const Vec3& point) const {
    Mat3 mobility;
    for (int k = 0; k < 3; ++k) {
        const Wrench change = response(wrench(point, Vec3::Unit(k)));
        const Vec3 turn = change.tail<3>();
        mobility.col(k) = change.head<3>() + turn.cross(point - centre);
    }
    return mobility;
}

Eigen::Matrix<double, 6, 6> Mobility::root() const {
    const Eigen::SelfAdjointEigenSolver<Mat3> axes(inverse_inertia);
    const Vec3 turns = axes.eigenvalues().cwiseMax(0).cwiseSqrt();  // zero about an axis that is locked
    Eigen::Matrix<double, 6, 6> root = Eigen::Matrix<double, 6, 6>::Zero();
    root.topLeftCorner<3, 3>() = std::sqrt(inverse_mass) * Mat3::Identity();
    root.bottomRightCorner<3, 3>() =
        axes.eigenvectors() * turns.asDiagonal() * axes.eigenvectors().transpose();
    return root;
}

}  // namespace sherd
