#include "core/mlpg/reduced/peak_table.h"

#include <gtest/gtest.h>

#include "core/mlpg/reduced/make_peak_table.h"
#include "core/mlpg/reduced/reduced_support.h"

namespace sherd {
namespace {

struct PeakTableTest : testing::Test {
    static const BothSolutions& wall() {
        static const BothSolutions both = bothSolutions(obliqueWall(), 0.02);
        return both;
    }
    static PeakTable tableOf(const BothSolutions& both) {
        return valueOf(makePeakTable({*both.problem, both.factor.solver(), both.factor.pinned(), both.patches,
                                      both.unit, both.reduced.model.modes()},
                                     locateSamples(*both.solid), Material{}));
    }
    static const PeakTable& table() {
        static const PeakTable made = tableOf(wall());
        return made;
    }
    static double largestEquivalent(const StressField& field) {
        const Material material;
        const FailureCriterion& criterion = *failureCriterion(material.failure_criterion);
        double largest = 0;
        for (const auto* stresses : {&field.particles, &field.surface})
            for (const SymmetricTensor& stress : *stresses)
                largest =
                    std::max(largest, criterion.equivalent_stress_pa(principalStresses(stress), material));
        return largest;
    }
    // Of loads of all sizes, near edges and away from them. Between its patches the table is about right.
    static void expectBounds(const BothSolutions& wall, const PeakTable& table) {
        std::mt19937 random(6);
        std::vector<double> bound_over_truth;
        for (int i = 0; i < 60; ++i) {
            const double radius = 0.008 * std::pow(8, i / 60.0);
            const auto loads = randomPush(*wall.solid, radius, random);
            const auto [unknowns, energy] = fullSolution(wall, loads);
            const double truth = largestEquivalent(stressUnder(wall, unknowns, loads));
            Vec3 place = Vec3::Zero(), force = Vec3::Zero();
            for (const PointForce& load : loads) {
                place += load.force.norm() * load.position;
                force += load.force;
            }
            const PeakTable::At at(
                table, {place.cast<float>(), force.normalized().cast<float>(), static_cast<float>(radius)});
            bound_over_truth.push_back(at.stress(force.cast<float>()) / truth);
            EXPECT_GT(0.5 * at.compliance() * force.squaredNorm(), 0.9 * energy);
            const double least = 0.5 * at.work(force.cast<float>()).squaredNorm();
            EXPECT_LT(0.5 * least, energy) << "half of what the first modes store";
        }
        std::sort(bound_over_truth.begin(), bound_over_truth.end());
        std::printf("the bound is %.2f to %.2f times the stress, %.2f in the median\n",
                    bound_over_truth.front(), bound_over_truth.back(), bound_over_truth[30]);
        EXPECT_GT(bound_over_truth.front(), 0.9);
        EXPECT_LT(bound_over_truth[30], 4) << "a bound far above all stress tells nothing";
    }
};

TEST_F(PeakTableTest, NoPushDoesMuchMoreThanTheTableSays) {
    expectBounds(wall(), table());
}

TEST_F(PeakTableTest, NorDoesItWhereTheVolumetricStrainIsProjected) {
    const BothSolutions rubber = bothSolutions(obliqueWall(), 0.02, {}, rubberLike());
    expectBounds(rubber, tableOf(rubber));
}

TEST_F(PeakTableTest, ABoundIsThatOfItsDirectionsAndNoMoreThanTheirSumInBetween) {
    for (const PeakTable::Level& level : table().levels)
        for (std::size_t p = 0; p < level.patches.size(); p += 37) {
            const PeakTable::Patch& patch = level.patches[p];
            for (int d = 0; d < PeakTable::directions; ++d) {
                const float own = level.peakOf(patch.peaks[d]);
                EXPECT_NEAR(level.peak(patch, patch.direction(d)), own, 1e-3 * own) << d;
                EXPECT_NEAR(level.peak(patch, 3 * patch.direction(d)), 3 * own, 3e-3 * own) << d;
            }
            const Eigen::Vector3f between = patch.direction(0) + patch.direction(1);
            EXPECT_LE(level.peak(patch, between),
                      1.001f * (level.peakOf(patch.peaks[0]) + level.peakOf(patch.peaks[1])));
        }
}

TEST_F(PeakTableTest, NumbersOfStressAreRoundedUpByLessThanATwentieth) {
    const PeakTable::Level& level = table().levels.front();
    for (float peak = 2 * level.unit_pa_n; peak < 50000 * level.unit_pa_n; peak *= 1.7f) {
        const float kept = level.peakOf(level.numberOf(peak));
        EXPECT_GE(kept, 0.99999f * peak);
        EXPECT_LT(kept, 1.05f * peak);
    }
    EXPECT_EQ(level.peakOf(level.numberOf(0)), 0);
}

TEST_F(PeakTableTest, TakesLessThanFiftyKilobytesAndHasPatchesOnTheEdges) {
    std::size_t bytes = 0, on_edges = 0;
    for (const PeakTable::Level& level : table().levels)
        for (const PeakTable::Patch& patch : level.patches) {
            bytes += 2 * sizeof patch.middle + sizeof patch.on_edge + sizeof patch.peaks +
                     2 * sizeof patch.work_scale + sizeof patch.work;
            on_edges += patch.on_edge;
        }
    EXPECT_LT(bytes, 50000u);
    EXPECT_GE(on_edges, 12u) << "the wall has 8 corners, and vertices on 12 edges";
}

}  // namespace
}  // namespace sherd
