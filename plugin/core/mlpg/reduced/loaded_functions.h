#pragma once

#include <sherd/result.h>

#include <vector>

#include "core/mlpg/splines/spline_problem.h"

namespace sherd {

/// What point forces are at the functions of a solid, and the rigid acceleration that balances them.
struct LoadedFunctions {
    struct Force {
        int function;
        Vec3 force;  ///< N; a function may have several
    };
    std::vector<Force> forces;
    Eigen::Matrix<double, 6, Eigen::Dynamic> acceleration;  ///< per component; zero where supports hold it
};

/// An error if a load is not finite, or outside the solid.
Result<LoadedFunctions> loadedFunctions(const SplineProblem& problem, const std::vector<PointForce>& loads);

}  // namespace sherd
