#include "core/mlpg/reduced/compliance_matrix.h"

#include <gtest/gtest.h>

#include "core/mlpg/reduced/archive.h"
#include "core/mlpg/reduced/reduced_support.h"

namespace sherd {
namespace {

struct ComplianceMatrixTest : testing::Test {
    static const BothSolutions& wall() {
        static const BothSolutions both = bothSolutions(obliqueWall(), 0.048);
        return both;
    }
    static ReducedModel direct(const BothSolutions& both) {
        return valueOf(
            ReducedModel::makeDirect(both.problem, both.factor.solver(), both.factor.pinned(), both.unit));
    }
};

void expectTheFullSolution(const BothSolutions& both, const ReducedModel& model, double radius) {
    std::mt19937 random(1);
    for (int i = 0; i < 10; ++i) {
        const auto loads = randomPush(*both.solid, radius, random);
        const auto [unknowns, energy] = fullSolution(both, loads);
        const ReducedResponse response = valueOf(model.respond(loads));
        EXPECT_NEAR(response.strain_energy_j, energy, 1e-4 * energy);
        const StressField full = stressUnder(both, unknowns, loads),
                          own = stressUnder(both, response.unknowns.cast<double>(), loads);
        EXPECT_NEAR(largestTension(own), largestTension(full), 1e-4 * largestTension(full));
        double difference = 0, norm = 0;
        for (std::size_t p = 0; p < full.particles.size(); ++p) {
            difference += (own.particles[p] - full.particles[p]).squaredNorm();
            norm += full.particles[p].squaredNorm();
        }
        EXPECT_LT(difference, 1e-8 * norm);
    }
}

TEST_F(ComplianceMatrixTest, AnswersAsTheFullSolveDoes) {
    expectTheFullSolution(wall(), direct(wall()), 0.05);
}

TEST_F(ComplianceMatrixTest, AnswersAnchoredSolidsToo) {
    std::vector<SupportPoint> foot;
    for (const SurfacePoint& point : wall().solid->surface_points)
        if (point.position.x() < -0.1) foot.push_back({point.position, point.area.norm()});
    ASSERT_GT(foot.size(), 3);
    const BothSolutions held = bothSolutions(obliqueWall(), 0.048, foot);
    expectTheFullSolution(held, direct(held), 0.05);
}

TEST_F(ComplianceMatrixTest, MovesNoSolidAsAWhole) {
    const Eigen::MatrixXd entries = direct(wall()).compliance().entries.cast<double>();
    EXPECT_EQ(entries, entries.transpose());
    const SplineProblem& problem = *wall().problem;
    // Loads that are rigid inertia forces strain nothing.
    const Eigen::MatrixXd strains = entries * problem.inertia.forces();
    for (Eigen::Index k = 0; k < strains.cols(); ++k)
        EXPECT_LT(strains.col(k).norm(), 1e-5 * entries.norm() * problem.inertia.forces().col(k).norm());
}

TEST_F(ComplianceMatrixTest, RefusesLoadsThatAreNotFinite) {
    const ReducedModel model = direct(wall());
    EXPECT_FALSE(model.respond({{wall().solid->particles[0].position, Vec3(0, NAN, 0)}}).ok());
    const Result<ReducedResponse> huge =
        model.respond({{wall().solid->particles[0].position, Vec3(0, 1e300, 0)}});
    EXPECT_FALSE(huge.ok());
}

TEST_F(ComplianceMatrixTest, ComesBackFromAnArchive) {
    const SplineSpace& space = *wall().problem->space;
    ASSERT_LE(3 * space.function_count, ReducedModelLimits{}.direct_unknowns);
    ComplianceMatrix written = direct(wall()).compliance(), back;
    ByteWriter writer;
    archiveCompliance(writer, space, written);
    ASSERT_TRUE(writer.good());
    ByteReader reader(writer.bytes().data(), writer.bytes().size());
    archiveCompliance(reader, space, back);
    EXPECT_TRUE(reader.good() && reader.left() == 0);
    EXPECT_EQ(back.entries, written.entries);

    written.entries(5, 3) = NAN;
    ByteWriter wrong;
    archiveCompliance(wrong, space, written);
    EXPECT_FALSE(wrong.good());
    ByteReader cut(writer.bytes().data(), writer.bytes().size() - 4);
    archiveCompliance(cut, space, back);
    EXPECT_FALSE(cut.good());
}

}  // namespace
}  // namespace sherd
