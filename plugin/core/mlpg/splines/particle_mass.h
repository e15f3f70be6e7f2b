#pragma once

#include <Eigen/Dense>
#include <vector>

#include "core/mlpg/splines/spline_field.h"
#include "core/mlpg/splines/spline_problem.h"

namespace sherd {

/// The mass matrix of a solid whose cut cells have no moments any more, by a few points in the sub-domain of
/// each particle that have its volume, its centroid and its second moments, but for what these have off the
/// diagonal inside a cell.
class ParticleMass {
  public:
    explicit ParticleMass(const SplineProblem& problem);

    /// M u, kg m, of a displacement (#unknowns, m).
    Eigen::VectorXd times(const Eigen::VectorXd& displacement) const;

  private:
    struct Point {
        int part;
        double mass_kg;
        Vec3 xi;
    };

    const SplineProblem& problem_;
    std::vector<Point> points_;
};

}  // namespace sherd
