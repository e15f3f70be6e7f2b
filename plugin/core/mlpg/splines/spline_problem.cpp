#include "core/mlpg/splines/spline_problem.h"

#include "core/mlpg/pinned_unknowns.h"
#include "core/mlpg/splines/damaged_parts.h"
#include "core/mlpg/splines/spline_loads.h"
#include "core/mlpg/splines/spline_motions.h"
#include "core/mlpg/splines/spline_stiffness.h"

namespace sherd {

SplineField SplineProblem::fieldOf(const Eigen::VectorXd& unknowns) const {
    return splineField(std::shared_ptr<const CellParts>(solid, &solid->parts), space, space->expand(unknowns),
                       elasticity, projection.get());
}

Result<SplineProblem> makeSplineProblem(std::shared_ptr<const Discretisation> solid, const Material& material,
                                        Basis basis, const std::vector<SupportPoint>& support_points,
                                        const std::vector<char>& damaged) {
    const CellParts& parts = solid->parts;
    const int degree = splineDegree(basis);
    if (parts.order < 2 * degree)
        return Error{"The solid was sampled with moments of order " + std::to_string(parts.order) +
                     "; splines of degree " + std::to_string(degree) + " need " + std::to_string(2 * degree) +
                     "."};
    const Elasticity elasticity(material);
    const auto space = std::make_shared<const SplineSpace>(parts, degree);
    RigidMotions motions = splineMotions(parts, *space);
    auto supports = supportSprings(parts, elasticity, support_points);
    if (!supports) return Error{supports.error()};
    auto held = heldComponents(parts, *space, motions, supports.value());
    if (!held) return Error{held.error()};
    Eigen::Matrix4Xd moments = inertiaMoments(parts, *space, motions);
    InertiaRelief inertia = splineInertia(moments, motions);
    std::vector<double> shares = stiffnessShares(*solid, damaged);
    auto projection = projectionFor(elasticity, parts, *space, shares);
    return SplineProblem{std::move(solid),
                         elasticity,
                         material.density_kg_m3,
                         std::move(shares),
                         space,
                         std::move(motions),
                         std::move(supports).value(),
                         std::move(held).value(),
                         std::move(moments),
                         std::move(inertia),
                         std::move(projection)};
}

Result<Eigen::VectorXd> forcesAt(const SplineProblem& problem, const std::vector<PointForce>& loads) {
    for (const PointForce& load : loads)
        if (!load.force.allFinite() || !load.position.allFinite())
            return Error{"A load on the body is not finite; check the contact that it came from."};
    Eigen::Matrix3Xd raw = Eigen::Matrix3Xd::Zero(3, problem.space->raw_count);
    if (!addPointForces(problem.parts(), *problem.space, loads, raw))
        return Error{
            "A load acts more than a particle spacing outside the body; give it in the asset's frame."};
    return problem.space->gather(raw);
}

BlockMatrix stiffnessOf(const SplineProblem& problem) {
    return splineStiffness(problem.parts(), *problem.space, problem.elasticity,
                           springsOf(problem.parts(), problem.supports), problem.projection.get(),
                           problem.shares);
}

std::vector<int> pinnedUnknowns(const SplineProblem& problem, const BlockMatrix& stiffness) {
    std::vector<int> pinned;
    for (const int unknown : unknownsToPin(problem.motions, stiffness))
        if (!problem.held[problem.motions.componentOfUnknown(unknown)]) pinned.push_back(unknown);
    return pinned;
}

void clearHeld(const SplineProblem& problem, Eigen::Matrix<double, 6, Eigen::Dynamic>& resultants) {
    for (size_t component = 0; component < problem.held.size(); ++component)
        if (problem.held[component]) resultants.col(static_cast<long>(component)).setZero();
}

}  // namespace sherd
