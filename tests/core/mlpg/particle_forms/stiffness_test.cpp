#include <gtest/gtest.h>

#include <cmath>

#include "core/mlpg/particle_forms/galerkin_stiffness.h"
#include "core/mlpg/particle_forms/heaviside_stiffness.h"
#include "core/mlpg/particle_forms/particle_inertia.h"
#include "core/mlpg/pinned_unknowns.h"
#include "core/sampling/sampling_support.h"
#include "support/shapes.h"

namespace sherd {
namespace {

Discretisation cutBlock() {
    const Mat3 tilt = Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    Result<Discretisation> solid =
        sampleSolid(shapes::moved(shapes::slab({0.5, 0.4, 0.3}), tilt), 0.12, SamplingSettings{});
    EXPECT_TRUE(solid.ok()) << solid.error();
    return std::move(solid).value();
}

StressProblem problemOf(const Discretisation& solid, TrialFunction trial) {
    StressSettings settings;
    settings.trial_function = trial;
    settings.basis = Basis::linear;
    Material material;
    material.youngs_modulus_pa = 1;
    material.poisson_ratio = 0.3;
    return StressProblem(solid, material, settings);
}

Eigen::MatrixXd denseOf(const BlockMatrix& matrix) {
    const int size = matrix.block_size;
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(matrix.size(), matrix.size());
    for (int c = 0; c < matrix.blockColumns(); ++c)
        for (int j = 0; j < size; ++j) {
            const double* value = matrix.column(c, j);
            for (int k = matrix.starts[c]; k < matrix.starts[c + 1]; ++k)
                for (int i = 0; i < size; ++i, ++value)
                    dense(size * matrix.rows[k] + i, size * c + j) =
                        dense(size * c + j, size * matrix.rows[k] + i) = *value;
        }
    return dense;
}

// The assembled matrix against the index formula, cell by cell, without any of its shortcuts.
TEST(GalerkinStiffness, IsTheSumOverCells) {
    const Discretisation solid = cutBlock();
    for (TrialFunction trial : {TrialFunction::mls, TrialFunction::gmls}) {
        const StressProblem problem = problemOf(solid, trial);
        const int m = problem.space.functionsPerParticle();
        Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(problem.unknowns(), problem.unknowns());
        for (size_t cell = 0; cell < solid.cells.size(); ++cell) {
            Eigen::MatrixXd strain = Eigen::MatrixXd::Zero(9, problem.unknowns());  // du_i/dx_j, row 3 i + j
            const auto g = problem.cells.ofCell(static_cast<int>(cell));
            for (long a = 0; a < g.cols(); ++a) {
                const long function = problem.cells.particles[problem.cells.starts[cell] + a / m] * m + a % m;
                for (int i = 0; i < 3; ++i)
                    for (int j = 0; j < 3; ++j) strain(3 * i + j, 3 * function + i) = g(j, a);
            }
            Eigen::MatrixXd law(9, 9);  // sigma of each unit gradient
            for (int i = 0; i < 9; ++i) {
                Mat3 unit = Mat3::Zero();
                unit(i / 3, i % 3) = 1;
                const Mat3 stress = problem.elasticity.stress(unit);
                for (int k = 0; k < 9; ++k) law(k, i) = stress(k / 3, k % 3);
            }
            expected += solid.cells[cell].moments.volume * strain.transpose() * law * strain;
        }
        const Eigen::MatrixXd found = denseOf(galerkinStiffness(solid, problem.cells, problem.elasticity));
        EXPECT_LT((found - expected).norm(), 1e-13 * expected.norm());
        EXPECT_LT((found * problem.motions.coefficients).norm(), 1e-12 * found.norm());
    }
}

// Six unknowns hold a free body, and what is left is positive definite.
TEST(GalerkinStiffness, PinsLeaveNoRigidMotion) {
    const Discretisation solid = cutBlock();
    const StressProblem problem = problemOf(solid, TrialFunction::gmls);
    BlockMatrix matrix = galerkinStiffness(solid, problem.cells, problem.elasticity);
    const std::vector<int> pins = unknownsToPin(problem.motions, matrix);
    ASSERT_EQ(pins.size(), 6u);
    pinUnknowns(matrix, pins);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> spectrum(denseOf(matrix));
    EXPECT_GT(spectrum.eigenvalues()[0], 1e-6 * spectrum.eigenvalues().tail<1>()[0]);
}

// Each face counts for both its sub-domains with opposite signs: the rows of every direction add up to zero.
TEST(HeavisideStiffness, ForcesBalanceAndRigidMotionsVanish) {
    const Discretisation solid = cutBlock();
    const StressProblem problem = problemOf(solid, TrialFunction::mls);
    const SparseMatrix rows = heavisideStiffness(fluxThroughSharedFaces(problem), solid, problem.motions);
    const int n = static_cast<int>(problem.unknowns());
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(rows.size, rows.size);
    for (int row = 0; row < rows.size; ++row)
        for (int k = rows.starts[row]; k < rows.starts[row + 1]; ++k)
            dense(row, rows.indices[k]) = rows.values[k];
    const Eigen::MatrixXd stiffness = dense.topLeftCorner(n, n);
    EXPECT_LT((stiffness * problem.motions.coefficients).norm(), 1e-12 * stiffness.norm());
    EXPECT_LT((stiffness.transpose() * problem.motions.coefficients.leftCols<3>()).norm(),
              1e-13 * stiffness.norm());
    EXPECT_LT((dense.topRightCorner(n, 6) - dense.bottomLeftCorner(6, n).transpose()).norm(), 1e-15);
}

// 4 x 4 points on every face that leads to a neighbour, for each of the two cubes: 96 for a particle inside
// the block, and 16 less for each face on its surface.
TEST(HeavisideCubes, Take96PointsInsideAndNoneOnFreeFaces) {
    for (const Eigen::Vector3i& n : {Eigen::Vector3i(5, 4, 3), Eigen::Vector3i(6, 4, 3)}) {
        const Result<Discretisation> solid =
            sampleSolid(shapes::slab(0.1 * n.cast<double>()), 0.1, SamplingSettings{});
        ASSERT_TRUE(solid.ok()) << solid.error();
        const HeavisideBlocks blocks = fluxThroughCubes(problemOf(solid.value(), TrialFunction::mls));
        int points = 0;
        for (const int count : blocks.evaluations) points += count;
        const int free_faces = 2 * (n.x() * n.y() + n.y() * n.z() + n.z() * n.x());
        ASSERT_EQ(blocks.rows.size(), static_cast<size_t>(n.prod()));
        EXPECT_EQ(points, 96 * n.prod() - 16 * free_faces);
    }
}

// Two cubes that share a face integrate it at the same points: forces balance as if it were integrated once.
TEST(HeavisideCubes, ForcesBalance) {
    const Result<Discretisation> solid = sampleSolid(shapes::slab({0.5, 0.4, 0.3}), 0.1, SamplingSettings{});
    ASSERT_TRUE(solid.ok()) << solid.error();
    const HeavisideBlocks blocks = fluxThroughCubes(problemOf(solid.value(), TrialFunction::mls));
    std::vector<Mat3> column_sums(blocks.rows.size(), Mat3::Zero());
    for (const auto& row : blocks.rows)
        for (const auto& [particle, block] : row) column_sums[particle] += block;
    for (size_t particle = 0; particle < blocks.rows.size(); ++particle) {
        Mat3 row_sum = Mat3::Zero();
        for (const auto& entry : blocks.rows[particle]) row_sum += entry.second;
        EXPECT_LT(row_sum.norm(), 1e-13);  // a translation makes no stress
        EXPECT_LT(column_sums[particle].norm(), 1e-13);
    }
}

// Unit acceleration along x loads the body with its volume; the six balance any load to rounding.
TEST(InertiaRelief, BalancesForceAndMoment) {
    const Discretisation solid = cutBlock();
    for (TrialFunction trial : {TrialFunction::mls, TrialFunction::gmls}) {
        const StressProblem problem = problemOf(solid, trial);
        const InertiaRelief relief = galerkinInertia(problem);
        Eigen::VectorXd forces = Eigen::VectorXd::Zero(problem.unknowns());
        forces[0] = 3;
        forces[problem.unknowns() - problem.space.unknownsPerParticle() + 1] = -2;
        relief.balance(forces, problem.motions.resultants(forces), problem.motions);
        EXPECT_LT(problem.motions.resultants(forces).norm(), 1e-13);
    }
}

// The discrete mass matrix of the rigid motions is that of the solid: volume, and inertia about the centre.
TEST(InertiaRelief, AccelerationIsThatOfTheRigidBody) {
    const Discretisation solid = cutBlock();
    for (const bool galerkin : {true, false}) {
        const StressProblem problem = problemOf(solid, galerkin ? TrialFunction::gmls : TrialFunction::mls);
        const InertiaRelief relief = galerkin ? galerkinInertia(problem) : heavisideInertia(problem);
        const Moments total = totalMoments(solid);
        const Mat3 inertia = total.second.trace() * Mat3::Identity() - total.second;
        const double size = problem.motions.size[0];
        Eigen::Matrix<double, 6, 6> expected = Eigen::Matrix<double, 6, 6>::Zero();
        expected.topLeftCorner<3, 3>() = total.volume * Mat3::Identity();
        expected.bottomRightCorner<3, 3>() = inertia / (size * size);
        EXPECT_LT((relief.mass(0) - expected).norm(), 1e-12 * expected.norm());
    }
}

}  // namespace
}  // namespace sherd
