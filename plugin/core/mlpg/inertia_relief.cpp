#include "core/mlpg/inertia_relief.h"

#include <Eigen/QR>

namespace sherd {
namespace {

std::vector<InertiaRelief::Mat6> resultantsOf(const InertiaRelief::Forces& forces,
                                              const RigidMotions& motions) {
    std::vector<InertiaRelief::Mat6> masses(motions.componentCount());
    for (int motion = 0; motion < 6; ++motion) {
        const auto sums = motions.resultants(forces.col(motion));
        for (int component = 0; component < motions.componentCount(); ++component)
            masses[component].col(motion) = sums.col(component);
    }
    return masses;
}

}  // namespace

InertiaRelief::InertiaRelief(Forces forces, std::vector<Mat6> masses)
    : forces_(std::move(forces)), masses_(std::move(masses)) {}

InertiaRelief::InertiaRelief(Forces forces, const RigidMotions& motions)
    : forces_(std::move(forces)), masses_(resultantsOf(forces_, motions)) {}

Eigen::Matrix<double, 6, Eigen::Dynamic> InertiaRelief::accelerationOf(
    const Eigen::Matrix<double, 6, Eigen::Dynamic>& resultants) const {
    Eigen::Matrix<double, 6, Eigen::Dynamic> acceleration(6, resultants.cols());
    for (long component = 0; component < resultants.cols(); ++component)
        acceleration.col(component) =
            masses_[static_cast<size_t>(component)].completeOrthogonalDecomposition().solve(
                -resultants.col(component));
    return acceleration;
}

Eigen::Matrix<double, 6, Eigen::Dynamic> InertiaRelief::balance(
    Eigen::VectorXd& forces, const Eigen::Matrix<double, 6, Eigen::Dynamic>& resultants,
    const RigidMotions& motions) const {
    const auto acceleration = accelerationOf(resultants);
    for (long unknown = 0; unknown < forces.size(); ++unknown)
        forces[unknown] += forces_.row(unknown).dot(acceleration.col(motions.componentOfUnknown(unknown)));
    return acceleration;
}

}  // namespace sherd
