#include "core/mlpg/reduced/damage_reading.h"

#include <gtest/gtest.h>

#include "core/mlpg/reduced/reduced_support.h"
#include "core/stress/principal_stresses.h"

namespace sherd {
namespace {

const BothSolutions& wall() {
    static const BothSolutions both = bothSolutions(obliqueWall(), 0.02);
    return both;
}

const BothSolutions& rubberWall() {
    static const BothSolutions both = bothSolutions(obliqueWall(), 0.02, {}, rubberLike());
    return both;
}

MaterialStrength scattered(double mean) {
    Material material;
    material.tensile_strength_pa = mean;
    material.strength_scatter = 0.2;
    return {material, 0.05, {}};
}

/// `rounding` of stress that is read in single precision.
void expectTheDamageOfReadingEverything(const BothSolutions& wall, double rounding) {
    std::mt19937 random(1);
    Material brittle;
    brittle.compressive_strength_pa = 8 * brittle.tensile_strength_pa;
    for (const char* name : {"largest_principal_stress", "mohr_coulomb"})
        for (const double of_peak : {0.2, 0.6, 0.9, 1.2, 3.0}) {
            const auto loads = randomPush(*wall.solid, 0.02, random);
            const auto response = valueOf(wall.reduced.model.respond(loads));
            const StressField field = stressUnder(wall, response.unknowns.cast<double>(), loads);
            const MaterialStrength strength = scattered(of_peak * largestTension(field) * 1000);
            const auto at_samples = strengthsAtSamples(strength, *wall.solid);
            const auto at_points = wall.reduced.reading.strengths(strength);
            const FailureCriterion& criterion = *failureCriterion(name);
            const Damage all = damagedParticles(field, 1000, *wall.solid, {criterion, brittle, at_samples});
            const Damage found = wall.reduced.reading.damage(response.unknowns, {{}, {}, loads}, 1000,
                                                             {criterion, brittle, at_points});
            EXPECT_EQ(found.count, all.count) << name << ' ' << of_peak;
            EXPECT_EQ(found.damaged, all.damaged);
            EXPECT_NEAR(found.largest_stress_pa, all.largest_stress_pa, rounding * all.largest_stress_pa);
            constexpr double far_beyond = 3, much_more = 1.5;  // from there on it is read roughly
            for (std::size_t i = 0; all.count > 0 && i < all.damaged.size(); ++i) {
                if (all.overstress[i] < 0.51) continue;
                EXPECT_LT(found.overstress[i], all.overstress[i] + 10 * rounding);
                if (found.overstress[i] < far_beyond)
                    EXPECT_NEAR(found.overstress[i], all.overstress[i], 10 * rounding);
                else
                    EXPECT_GT(found.overstress[i], all.overstress[i] / much_more);
            }
        }
}

TEST(DamageReading, FindsTheDamageThatReadingEverythingFinds) {
    expectTheDamageOfReadingEverything(wall(), 1e-5);
}

TEST(DamageReading, FindsItWhereTheVolumetricStrainIsProjected) {
    ASSERT_TRUE(rubberWall().problem->projection);
    expectTheDamageOfReadingEverything(rubberWall(), 1e-4);  // lambda is 24 mu
}

void expectBoundsToHold(const BothSolutions& wall) {
    std::mt19937 random(2);
    const SplineProblem& problem = *wall.problem;
    const auto samples = locateSamples(*wall.solid);
    const StressBounds bounds(problem.parts(), problem.space->degree, problem.elasticity, samples);
    Eigen::Matrix4Xf raw = Eigen::Matrix4Xf::Zero(4, problem.space->raw_count);
    for (Eigen::Index i = 0; i < raw.cols(); ++i)
        for (int k = 0; k < 3; ++k) raw(k, i) = static_cast<float>((random() % 2000) * 1e-3 - 1);
    const SplineField field =
        splineField(std::shared_ptr<const CellParts>(wall.solid, &problem.parts()), problem.space,
                    raw.topRows<3>().cast<double>(), problem.elasticity, problem.projection.get());
    Eigen::MatrixXf dilatation;
    if (problem.projection) dilatation = problem.projection->dilatation<float>(raw.topRows<3>());
    const std::vector<PrincipalRange> ranges = bounds.ranges(raw, problem.space->raw_of, dilatation);
    ASSERT_EQ(ranges.size(), problem.parts().parts.size());
    for (std::size_t s = 0; s < samples.size(); ++s) {
        if (samples[s].part < 0) continue;
        const SymmetricTensor own =
            toSymmetricTensor(problem.elasticity.stress(gradientOn(field, samples[s].part, samples[s].xi)));
        const PrincipalRange& range = ranges[samples[s].part];
        const PrincipalStresses principal = principalStresses(own);
        ASSERT_LE(principal.largest, range.largest);
        ASSERT_GE(principal.smallest, range.smallest);
        if (s < wall.solid->particles.size()) continue;
        const SurfacePoint& point = wall.solid->surface_points[s - wall.solid->particles.size()];
        if (point.normal.isZero()) continue;
        const PrincipalStresses free =
            principalStresses(withTraction(own, point.normal, Vec3::Zero(), problem.elasticity));
        ASSERT_LE(free.largest, range.largest);
        ASSERT_GE(free.smallest, range.smallest);
    }
}

TEST(StressBounds, HoldOfAnyDisplacement) {
    expectBoundsToHold(wall());
}

TEST(StressBounds, HoldOfAnyProjectedStrain) {
    expectBoundsToHold(rubberWall());
}

}  // namespace
}  // namespace sherd
