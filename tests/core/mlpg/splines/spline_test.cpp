#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "core/linear_algebra/conjugate_gradients.h"
#include "core/mlpg/splines/part_integrals.h"
#include "core/mlpg/splines/spacing_choice.h"
#include "core/mlpg/splines/spline_refinement.h"
#include "core/mlpg/splines/zoom.h"
#include "core/numerics/gauss_legendre.h"
#include "core/sampling/cell_moments.h"
#include "core/sampling/sample_solid.h"
#include "support/shapes.h"

namespace sherd {
namespace {

Mat3 someRotation() {
    return (Eigen::AngleAxisd(0.4, Vec3::UnitX()) * Eigen::AngleAxisd(0.7, Vec3::UnitY())).toRotationMatrix();
}

TriangleMesh tiltedBox() {
    return shapes::moved(shapes::slab({1, 0.6, 0.4}), someRotation());
}

CellParts partsOf(const TriangleMesh& mesh, double spacing, int degree) {
    SamplingSettings settings;
    settings.moment_order = 2 * degree;
    const Result<Discretisation> solid = sampleSolid(mesh, spacing, settings);
    EXPECT_TRUE(solid.ok()) << solid.error();
    return solid.value().parts;
}

/// Unknowns of a displacement that is linear in x: read at the middles of the functions.
Eigen::VectorXd linearUnknowns(const SplineSpace& space, const Mat3& gradient) {
    Eigen::VectorXd unknowns(3L * space.function_count);
    for (int f = 0; f < space.function_count; ++f) unknowns.segment<3>(3L * f) = gradient * space.centres[f];
    return unknowns;
}

Eigen::VectorXd randomVector(long size, unsigned seed) {
    std::mt19937 random(seed);
    Eigen::VectorXd values(size);
    for (double& value : values) value = random() / 4294967296.0 - 0.5;
    return values;
}

// Paper, Eq. 6-10, with tensor products of B-splines as weights and particles on a whole lattice: phi_i = p^T
// M^-1 p_i w_i must be the B-splines themselves.
TEST(Spline, AreMovingLeastSquaresWithSplineWeights) {
    for (int degree = 1; degree <= 3; ++degree) {
        const Vec3 xi(0.21, -0.37, 0.05);
        std::vector<double> weights;
        splineValues(degree, xi, weights);
        const int width = degree + 1;
        Eigen::Matrix4d moment = Eigen::Matrix4d::Zero();
        std::vector<Eigen::Vector4d> basis;
        for (size_t n = 0; n < weights.size(); ++n) {
            const Vec3 node =
                Vec3(n % width, n / width % width, n / width / width) - Vec3::Constant(degree / 2.0);
            basis.emplace_back(1, node.x() - xi.x(), node.y() - xi.y(), node.z() - xi.z());
            moment += weights[n] * basis[n] * basis[n].transpose();
        }
        const Eigen::Vector4d p = moment.inverse().col(0);
        for (size_t n = 0; n < weights.size(); ++n)
            EXPECT_NEAR(p.dot(basis[n]) * weights[n], weights[n], 1e-14);
    }
}

TEST(Spline, GradientsAreThoseOfTheValues) {
    constexpr double step = 1e-6;
    for (int degree = 1; degree <= 3; ++degree) {
        const Vec3 xi(0.11, 0.29, -0.44);
        std::vector<Vec3> gradients;
        splineGradients(degree, xi, gradients);
        for (int d = 0; d < 3; ++d) {
            std::vector<double> above, below;
            splineValues(degree, xi + step * Vec3::Unit(d), above);
            splineValues(degree, xi - step * Vec3::Unit(d), below);
            for (size_t a = 0; a < gradients.size(); ++a)
                EXPECT_NEAR(gradients[a][d], (above[a] - below[a]) / (2 * step), 1e-8);
        }
    }
}

// Volume, centre and second moment of all parts against the box's own: V, V c, V (c c^T + R diag(a^2/12)
// R^T).
TEST(CellParts, MomentsAddUpToTheSolid) {
    const Mat3 rotation = someRotation();
    const Vec3 offset(0.3, -0.2, 0.1), size(1, 0.6, 0.4);
    const CellParts solid = partsOf(shapes::moved(shapes::slab(size), rotation, offset), 0.13, 2);
    double volume = 0;
    Vec3 first = Vec3::Zero();
    for (const CellPart& part : solid.parts) {
        const Vec3 middle =
            solid.origin + (part.cell.cast<double>() + Vec3::Constant(0.5)).cwiseProduct(solid.edges);
        const double cell = solid.edges.prod();
        volume += cell * part.fill;
        first += cell * part.fill * middle;
        if (part.moments.empty()) continue;
        const int n = solid.order + 1;
        first += cell * Vec3(part.moments[1], part.moments[n], part.moments[n * n]).cwiseProduct(solid.edges);
    }
    EXPECT_NEAR(volume, size.prod(), 1e-12);
    EXPECT_LT((first / volume - offset).norm(), 1e-12);
}

// Whole cells: the contraction of moments against a Gauss rule that is exact.
TEST(PartIntegrals, AgreeWithQuadrature) {
    const Vec3 edges(0.2, 0.3, 0.1);
    for (int degree = 1; degree <= 3; ++degree) {
        const PartIntegrals integrals(degree, edges);
        const GaussRule rule = gaussLegendre(degree + 1);
        const size_t count = (degree + 1) * (degree + 1) * (degree + 1);
        Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(count, count);
        std::vector<Vec3> gradients;
        for (size_t q = 0; q < count; ++q) {
            const size_t i = q % (degree + 1), j = q / (degree + 1) % (degree + 1),
                         k = q / (degree + 1) / (degree + 1);
            splineGradients(degree, Vec3(rule.points[i], rule.points[j], rule.points[k]), gradients);
            const double weight = edges.prod() * rule.weights[i] * rule.weights[j] * rule.weights[k];
            for (size_t a = 0; a < count; ++a)
                for (size_t b = 0; b < count; ++b)
                    expected(a, b) += weight * gradients[a].x() / edges.x() * gradients[b].z() / edges.z();
        }
        EXPECT_LT((integrals.wholeCell()[2] - expected).norm(), 1e-12 * expected.norm());
    }
}

TEST(SplineSpace, LinearDisplacementsHaveTheirGradientEverywhere) {
    Mat3 gradient;
    gradient << 1, 2, 3, 4, 5, 6, 7, 8, 10;
    for (int degree = 1; degree <= 3; ++degree) {
        const CellParts solid = partsOf(tiltedBox(), 0.14, degree);
        const auto space = std::make_shared<SplineSpace>(solid, degree);
        EXPECT_LT(space->function_count, space->raw_count) << "some functions see slivers only, and are tied";
        const SplineField field{std::make_shared<CellParts>(solid), space,
                                space->expand(linearUnknowns(*space, gradient))};
        for (size_t p = 0; p < solid.parts.size(); ++p) {
            const Mat3 got = gradientOn(field, static_cast<int>(p), Vec3(0.2, -0.3, 0.4));
            EXPECT_LT((got - gradient).norm(), 1e-10 * gradient.norm());
        }
    }
}

TEST(SplineSpace, NothingIsSharedAcrossAGap) {
    // Two plates with an air gap of half a cell between them.
    const TriangleMesh plates = shapes::joined(shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 0.2)),
                                               shapes::box(Vec3(0, 0, 0.25), Vec3(1, 1, 0.45)));
    const CellParts solid = partsOf(plates, 0.1, 2);
    const SplineSpace space(solid, 2);
    EXPECT_EQ(space.component_count, 2);
    for (size_t p = 0; p < solid.parts.size(); ++p)
        for (const int raw : space.raw_of[p])
            for (int k = space.term_starts[raw]; k < space.term_starts[raw + 1]; ++k)
                EXPECT_EQ(space.component[space.terms[k].function], space.component_of_part[p]);
}

// The refined grid can say all that the coarse one says.
TEST(SplineRefinement, KeepsTheDisplacement) {
    const TriangleMesh mesh = tiltedBox();
    for (int degree = 1; degree <= 3; ++degree) {
        const CellParts coarse = partsOf(mesh, 0.2, degree);
        const auto space = std::make_shared<SplineSpace>(coarse, degree);
        const SplineField field{std::make_shared<CellParts>(coarse), space,
                                space->expand(randomVector(3L * space->function_count, 3))};
        const Result<CellParts> fine =
            refineCellParts(mesh, coarse, Eigen::Vector3i(1, 1, 1), Eigen::Vector3i(4, 4, 3));
        ASSERT_TRUE(fine.ok()) << fine.error();
        const auto fine_space = std::make_shared<SplineSpace>(fine.value(), degree);
        const std::vector<int> parents = parentParts(coarse, fine.value());
        const SplineField refined{
            std::make_shared<CellParts>(fine.value()), fine_space,
            refinedCoefficients(coarse, *space, field.raw, fine.value(), *fine_space, parents)};
        ASSERT_GT(fine.value().parts.size(), 20u);
        double volume = 0, box_volume = 0;
        for (size_t p = 0; p < fine.value().parts.size(); ++p) {
            const CellPart& part = fine.value().parts[p];
            volume += part.fill;
            const Vec3 xi(0.1, -0.2, 0.3);
            const Vec3 x =
                fine.value().origin +
                (part.cell.cast<double>() + Vec3::Constant(0.5) + xi).cwiseProduct(fine.value().edges);
            const CellPart& parent = coarse.parts[parents[p]];
            const Mat3 expected = gradientOn(field, parents[p], coarse.toCell(x, parent.cell));
            EXPECT_LT((gradientOn(refined, static_cast<int>(p), xi) - expected).norm(),
                      1e-9 * (1 + expected.norm()));
        }
        for (const CellPart& part : coarse.parts)
            if ((part.cell.array() >= 1).all() && part.cell.x() < 4 && part.cell.y() < 4 && part.cell.z() < 3)
                box_volume += 8 * part.fill;
        EXPECT_NEAR(volume, box_volume, 1e-9) << "the same solid";
    }
}

// Tridiagonal (-1, 2, -1) and a known solution.
TEST(ConjugateGradients, SolveAndSayWhenTheyCannot) {
    constexpr int size = 60;
    SparseMatrix lower;
    lower.size = size;
    lower.starts.push_back(0);
    for (int i = 0; i < size; ++i) {
        lower.indices.push_back(i);
        lower.values.push_back(2);
        if (i + 1 < size) {
            lower.indices.push_back(i + 1);
            lower.values.push_back(-1);
        }
        lower.starts.push_back(static_cast<int>(lower.indices.size()));
    }
    const Eigen::VectorXd expected = randomVector(size, 5);
    Eigen::VectorXd b = 2 * expected;
    b.head(size - 1) -= expected.tail(size - 1);
    b.tail(size - 1) -= expected.head(size - 1);
    const Result<Eigen::VectorXd> x = solveByConjugateGradients(lower, b, 1e-12);
    ASSERT_TRUE(x.ok()) << x.error();
    EXPECT_LT((x.value() - expected).norm(), 1e-9);
    EXPECT_FALSE(solveByConjugateGradients(lower, b, 0).ok());
}

TEST(SpacingChoice, KeepsTheFactorWithinItsLimit) {
    const TriangleMesh slab = shapes::slab({1, 1, 0.1});
    const Result<double> free = chooseSpacing(slab, {0.05, 0.1, 2, 1e9, 1e9}, 2);
    ASSERT_TRUE(free.ok());
    EXPECT_DOUBLE_EQ(free.value(), 0.05);
    const Result<double> limited = chooseSpacing(slab, {0.01, 0.1, 2, 1e6, 1e6}, 2);
    ASSERT_TRUE(limited.ok());
    EXPECT_GT(limited.value(), 0.06);
    EXPECT_LT(limited.value(), 0.15);
    // Walls thinner than that spacing get more.
    const Result<double> thin = chooseSpacing(slab, {0.01, 0.07, 2, 1e6, 1e8}, 2);
    ASSERT_TRUE(thin.ok());
    EXPECT_NEAR(thin.value(), 0.07, 1e-12);
}

}  // namespace
}  // namespace sherd
