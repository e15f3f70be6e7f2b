#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <vector>

#include "core/mlpg/pinned_system.h"
#include "core/mlpg/reduced/reduced_stress.h"
#include "core/mlpg/splines/stress_reading.h"
#include "core/sampling/sample_solid.h"
#include "core/stress/surface_traction.h"
#include "support/shapes.h"

namespace sherd {

template <class T>
T valueOf(Result<T> result) {
    EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error());
    return std::move(result).value();
}

/// A solid with its full and its reduced solution.
struct BothSolutions {
    std::shared_ptr<const Discretisation> solid;
    std::shared_ptr<const SplineProblem> problem;
    BlockMatrix stiffness;
    PinnedSystem factor;
    ReducedStress reduced;
    std::vector<UnitPatch> patches;
    UnitResponses unit;  ///< on these
};

inline BothSolutions bothSolutions(const TriangleMesh& surface, double spacing,
                                   const std::vector<SupportPoint>& supports = {},
                                   const Material& material = {}) {
    SamplingSettings sampling;
    auto solid = std::make_shared<const Discretisation>(valueOf(sampleSolid(surface, spacing, sampling)));
    auto problem = std::make_shared<const SplineProblem>(
        valueOf(makeSplineProblem(solid, material, Basis::quadratic, supports, {})));
    BlockMatrix stiffness = stiffnessOf(*problem);
    PinnedSystem factor = valueOf(
        PinnedSystem::factor(stiffness, pinnedUnknowns(*problem, stiffness), problem->space->highest_cells));
    std::vector<UnitPatch> patches = unitPatches(*solid, ReducedModelLimits{}.patches);
    UnitResponses unit = valueOf(unitResponses(*problem, factor.solver(), factor.pinned(), patches));
    ReducedStress reduced{valueOf(ReducedModel::make(problem, stiffness, unit)),
                          DamageReading(problem, locateSamples(*solid)),
                          {},
                          {}};
    return {std::move(solid),   std::move(problem), std::move(stiffness), std::move(factor),
            std::move(reduced), std::move(patches), std::move(unit)};
}

/// A wall, 0.4 x 0.3 x 0.04, whose faces are oblique to the grid.
inline TriangleMesh obliqueWall() {
    const Mat3 rotation = Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    return shapes::moved(shapes::slab({0.4, 0.3, 0.04}, 4, 3, 1), rotation);
}

/// Whose volume hardly changes, so that its stress is read with the projected volumetric strain.
inline Material rubberLike() {
    Material material;
    material.poisson_ratio = 0.48;
    return material;
}

/// Loads of 1 N in total on a patch about a random point of the surface, inwards within half a right angle.
inline std::vector<PointForce> randomPush(const Discretisation& solid, double radius, std::mt19937& random) {
    const auto number = [&] { return (random() % 2000) * 1e-3 - 1; };
    const SurfacePoint* middle = nullptr;
    while (!middle || middle->normal.isZero())
        middle = &solid.surface_points[random() % solid.surface_points.size()];
    const Vec3 push = (-middle->normal + 0.4 * Vec3(number(), number(), number())).normalized();
    std::vector<PointForce> loads;
    double area = 0;
    for (const SurfacePoint& point : solid.surface_points) {
        if ((point.position - middle->position).norm() > radius || point.normal.dot(middle->normal) < 0.5)
            continue;
        loads.push_back({point.position, point.area.norm() * push});
        area += point.area.norm();
    }
    for (PointForce& load : loads) load.force /= area;
    return loads;
}

/// The full solution under balanced loads: unknowns and strain energy.
inline std::pair<Eigen::VectorXd, double> fullSolution(const BothSolutions& both,
                                                       const std::vector<PointForce>& loads) {
    const SplineProblem& problem = *both.problem;
    Eigen::Matrix3Xd raw = Eigen::Matrix3Xd::Zero(3, problem.space->raw_count);
    EXPECT_TRUE(addPointForces(problem.parts(), *problem.space, loads, raw));
    Eigen::VectorXd forces = problem.space->gather(raw);
    auto resultants = problem.motions.resultants(forces);
    clearHeld(problem, resultants);
    problem.inertia.balance(forces, resultants, problem.motions);
    Eigen::VectorXd held = forces, unknowns;
    for (const int unknown : both.factor.pinned()) held[unknown] = 0;
    EXPECT_TRUE(both.factor.solver().solve(held, unknowns));
    return {unknowns, 0.5 * unknowns.dot(forces)};
}

inline StressField stressUnder(const BothSolutions& both, const Eigen::VectorXd& unknowns,
                               const std::vector<PointForce>& loads) {
    StressField field;
    readStress(*both.problem, locateSamples(*both.solid), both.problem->fieldOf(unknowns), {}, {}, field);
    freeSurface(*both.solid, loads, both.problem->elasticity, field.surface);
    return field;
}

inline double largestTension(const StressField& field) {
    double largest = 0;
    for (const SymmetricTensor& stress : field.particles)
        largest = std::max(largest, largestPrincipal(stress));
    for (const SymmetricTensor& stress : field.surface) largest = std::max(largest, largestPrincipal(stress));
    return largest;
}

}  // namespace sherd
