#include "core/mlpg/splines/particle_mass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>

#include "core/mlpg/splines/spline_mass.h"
#include "core/sampling/sample_solid.h"
#include "support/shapes.h"

namespace sherd {
namespace {

SplineProblem problemOf(const TriangleMesh& surface, double spacing) {
    auto solid =
        std::make_shared<const Discretisation>(sampleSolid(surface, spacing, SamplingSettings{}).value());
    return makeSplineProblem(solid, Material(), Basis::quadratic, {}, {}).value();
}

/// The coefficients of a displacement: its values where a linear one has its coefficients.
Eigen::VectorXd coefficients(const SplineSpace& space, const std::function<Vec3(const Vec3&)>& u) {
    Eigen::VectorXd all(3 * space.function_count);
    for (int f = 0; f < space.function_count; ++f) all.segment<3>(3 * f) = u(space.greville_points[f]);
    return all;
}

TEST(ParticleMass, IsThatOfTheMomentsOfCutCells) {
    const Mat3 oblique = Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    for (const TriangleMesh& surface :
         {shapes::moved(shapes::slab({0.4, 0.3, 0.04}, 4, 3, 1), oblique), shapes::icosphere(0.2, 3)}) {
        const SplineProblem problem = problemOf(surface, 0.03);
        const ParticleMass mass(problem);
        const SparseMatrix exact = splineMass(problem.parts(), *problem.space);
        const auto energy = [&](const Eigen::VectorXd& u) {
            return problem.density_kg_m3 * u.dot(Eigen::VectorXd(massProduct(exact, u)));
        };
        const Eigen::VectorXd turning = coefficients(
            *problem.space, [](const Vec3& x) { return Vec3(Vec3(1, 2, 3).cross(x) + Vec3(0, 1, 0)); });
        EXPECT_NEAR(turning.dot(mass.times(turning)), energy(turning), 1e-5 * energy(turning));
        // Six cells a wave, the shortest that the grid follows.
        const Eigen::VectorXd wave = coefficients(*problem.space, [](const Vec3& x) {
            return Vec3(std::sin(35 * x.x()), std::cos(35 * x.z()), std::sin(35 * x.y()));
        });
        EXPECT_NEAR(wave.dot(mass.times(wave)), energy(wave), 0.01 * energy(wave));
        const Eigen::VectorXd off =
            mass.times(wave) - problem.density_kg_m3 * Eigen::VectorXd(massProduct(exact, wave));
        EXPECT_LT(off.norm(), 0.05 * mass.times(wave).norm());
    }
}

}  // namespace
}  // namespace sherd
