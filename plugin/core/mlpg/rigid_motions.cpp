#include "core/mlpg/rigid_motions.h"

#include <cmath>

namespace sherd {

RigidMotions::RigidMotions(std::vector<int> component_of, std::vector<Moments> component_moments,
                           int unknowns)
    : component_of_node(std::move(component_of)),
      moments(std::move(component_moments)),
      unknowns_per_node(unknowns) {
    for (const Moments& m : moments) size.push_back(std::sqrt(m.second.trace() / m.volume));
    coefficients.setZero(static_cast<long>(component_of_node.size()) * unknowns_per_node, 6);
}

Eigen::Matrix<double, 3, 6> RigidMotions::at(const Vec3& x, int component) const {
    Eigen::Matrix<double, 3, 6> motions;
    motions.leftCols<3>().setIdentity();
    motions.rightCols<3>() = -crossMatrix(x - moments[component].centroid) / size[component];
    return motions;
}

Eigen::Matrix<double, 6, Eigen::Dynamic> RigidMotions::resultants(const Eigen::VectorXd& forces) const {
    Eigen::Matrix<double, 6, Eigen::Dynamic> sums;
    sums.setZero(6, componentCount());
    for (long unknown = 0; unknown < forces.size(); ++unknown)
        if (forces[unknown] != 0)  // inertia forces of one motion are zero in most of them
            sums.col(componentOfUnknown(unknown)) += forces[unknown] * coefficients.row(unknown).transpose();
    return sums;
}

}  // namespace sherd
