#include "core/mlpg/splines/spline_supports.h"

#include <Eigen/Eigenvalues>

namespace sherd {
namespace {

/// In (lambda + 2 mu) / h: high against the body, low against rounding.
constexpr double support_stiffness = 100;

/// Of the weakest held motion over the strongest.
constexpr double smallest_hold = 1e-6;

}  // namespace

std::vector<PointSpring> springsOf(const CellParts& solid, const std::vector<SupportSpring>& supports) {
    std::vector<PointSpring> springs;
    for (const SupportSpring& support : supports) {
        const int part = solid.partAt(support.position);
        if (part >= 0)
            springs.push_back(
                {part, solid.toCell(support.position, solid.parts[part].cell), support.stiffness_n_m});
    }
    return springs;
}

Result<std::vector<SupportSpring>> supportSprings(const CellParts& solid, const Elasticity& elasticity,
                                                  const std::vector<SupportPoint>& points) {
    const double stiffness =
        support_stiffness * (elasticity.lambda_pa + 2 * elasticity.mu_pa) / solid.edges.maxCoeff();
    std::vector<SupportSpring> springs;
    for (const SupportPoint& point : points) {
        if (solid.partAt(point.position) < 0)
            return Error{"The stress could not be solved: a support lies beside the solid."};
        springs.push_back({point.position, stiffness * point.area_m2});
    }
    return springs;
}

Result<std::vector<char>> heldComponents(const CellParts& solid, const SplineSpace& space,
                                         const RigidMotions& motions,
                                         const std::vector<SupportSpring>& supports) {
    using Mat6 = Eigen::Matrix<double, 6, 6>;
    std::vector<char> held(space.component_count, 0);
    std::vector<Mat6> holds(space.component_count, Mat6::Zero());  // stiffness against the rigid motions
    for (const SupportSpring& support : supports) {
        const int part = solid.partAt(support.position);
        if (part < 0) continue;
        const int component = space.component_of_part[part];
        const Eigen::Matrix<double, 3, 6> motion = motions.at(support.position, component);
        held[component] = 1;
        holds[component] += support.stiffness_n_m * motion.transpose() * motion;
    }
    for (int component = 0; component < space.component_count; ++component) {
        if (!held[component]) continue;
        const Eigen::SelfAdjointEigenSolver<Mat6> solver(holds[component], Eigen::EigenvaluesOnly);
        if (solver.eigenvalues()[0] < smallest_hold * solver.eigenvalues()[5])
            return Error{
                "The stress could not be solved: the supports lie in a point or on a line, so that the body "
                "is free to turn about it; hold a larger part."};
    }
    return held;
}

}  // namespace sherd
