#include "core/mlpg/splines/spacing_choice.h"

#include <gtest/gtest.h>

#include "core/linear_algebra/cholesky_solver.h"
#include "core/mlpg/splines/stiffness_pattern.h"
#include "core/sampling/sample_solid.h"
#include "support/shapes.h"

namespace sherd {
namespace {

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

double entriesAt(const TriangleMesh& body, double spacing) {
    const Result<CellParts> parts = sampleParts(body, spacing, 2, 0, MomentRule::quick);
    EXPECT_TRUE(parts.ok());
    const SplineSpace space(parts.value(), 2);
    const Result<double> entries =
        factorEntriesOf(emptyMatrixOf(StiffnessPattern(space)), space.highest_cells);
    EXPECT_TRUE(entries.ok());
    constexpr double supernodal_surplus = 1.25;
    return supernodal_surplus * entries.value();
}

// An aeroplane whose factor had half of the entries it may have was wrong by 10 % at the tail instead of 7.
TEST(SpacingChoice, UsesMostOfTheLimit) {
    const Mat3 turned = Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    const TriangleMesh bodies[] = {
        shapes::slab({1, 1, 0.2}),      shapes::moved(shapes::slab({1, 1, 0.2}), turned),
        shapes::icosphere(0.5, 3),      shapes::uShape(0.2, 0.3, 0.8, 0.4),
        shapes::tube(0.5, 0.35, 1, 48), shapes::box(Vec3(0, 0, 0), Vec3(0.3, 0.35, 2))};
    double uses = 0;
    int count = 0;
    for (const TriangleMesh& body : bodies)
        for (const double largest : {0.5e6, 0.7e6, 1e6, 1.4e6}) {
            const Result<double> spacing = chooseSpacing(body, {0.001, 0.2, 2, largest, largest}, 2);
            ASSERT_TRUE(spacing.ok());
            const double use = entriesAt(body, spacing.value()) / largest;
            EXPECT_LE(use, 1);
            EXPECT_GT(use, 0.55);  // entries jump where the grid gets another layer of cells
            uses += use;
            ++count;
        }
    EXPECT_GT(uses / count, 0.8);
}

}  // namespace
}  // namespace sherd
