#include "core/mlpg/particle_forms/centred_fit.h"

#include <Eigen/Eigenvalues>

namespace sherd {

void CentredFit::add(const Vec3& point, double weight) {
    if (weight_ == 0) origin_ = point;
    const Vec3 offset = point - origin_;
    weight_ += weight;
    mean_ += weight * offset;
    inverse_covariance_ += weight * offset * offset.transpose();
}

bool CentredFit::finish(double smallest_spread) {
    if (!(weight_ > 0)) return false;
    mean_ /= weight_;
    const Mat3 covariance = inverse_covariance_ / weight_ - mean_ * mean_.transpose();
    mean_ += origin_;

    const Eigen::SelfAdjointEigenSolver<Mat3> spectrum(covariance);
    inverse_covariance_.setZero();
    rank_ = 0;
    for (int k = 0; k < 3; ++k) {
        if (spectrum.eigenvalues()[k] <= smallest_spread * smallest_spread) continue;
        const Vec3 axis = spectrum.eigenvectors().col(k);
        inverse_covariance_ += axis * axis.transpose() / spectrum.eigenvalues()[k];
        ++rank_;
    }
    return true;
}

}  // namespace sherd
