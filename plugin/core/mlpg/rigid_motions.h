#pragma once

#include <Eigen/Dense>
#include <vector>

#include "core/sampling/discretisation.h"

namespace sherd {

/// The six rigid motions of every connected component of a body: three translations, and three rotations
/// about the component's centre of mass divided by its size, so that all six move points by about as much.
/// Nodes are what carries the unknowns of a trial space: particles, or spline functions.
struct RigidMotions {
    std::vector<int> component_of_node;
    std::vector<Moments> moments;  ///< per component
    std::vector<double> size;      ///< per component: the length that rotations are divided by, m
    int unknowns_per_node;
    /// #unknowns x 6: each motion of the node's component in terms of the unknowns, whose number for node n
    /// and index i is n * unknowns_per_node + i. Whoever knows the trial space fills it in.
    Eigen::Matrix<double, Eigen::Dynamic, 6> coefficients;

    RigidMotions(std::vector<int> component_of_node, std::vector<Moments> component_moments,
                 int unknowns_per_node);

    int componentCount() const { return static_cast<int>(moments.size()); }
    int componentOfUnknown(long unknown) const {
        return component_of_node[static_cast<size_t>(unknown / unknowns_per_node)];
    }

    /// Velocities at x of the six motions of a component, 3 x 6.
    Eigen::Matrix<double, 3, 6> at(const Vec3& x, int component) const;

    /// Work of generalised forces on each motion, 6 x #components: net force, and net moment over size.
    Eigen::Matrix<double, 6, Eigen::Dynamic> resultants(const Eigen::VectorXd& forces) const;
};

/// The matrix of v x.
inline Mat3 crossMatrix(const Vec3& v) {
    Mat3 m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
}

}  // namespace sherd
