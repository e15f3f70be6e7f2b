#include "core/mlpg/reduced/vibration_modes.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/linear_algebra/block_product.h"
#include "core/mlpg/reduced/reduced_support.h"

namespace sherd {
namespace {

/// A slender rod of 1 x 0.03 x 0.02 m.
const BothSolutions& rod() {
    static const BothSolutions both = bothSolutions(shapes::slab({1, 0.03, 0.02}, 20, 1, 1), 0.01);
    return both;
}

// Of a free beam: w = (k L)^2 / L^2 sqrt(E I / (rho A)) with cos(k L) cosh(k L) = 1. Shear and rotation,
// which are left out, slow the third down by 3 %.
TEST(VibrationModes, OfARodAreEulersAndBernoullis) {
    const Material material;
    const double speed = std::sqrt(material.youngs_modulus_pa / material.density_kg_m3);
    const Eigen::ArrayXd& rates = rod().reduced.model.vibrations().rates_rad_s;
    ASSERT_GE(rates.size(), 6);
    std::vector<double> expected;
    for (const double kl : {4.73004, 7.85320, 10.99561})
        for (const double height : {0.02, 0.03})
            expected.push_back(kl * kl * height / std::sqrt(12.0) * speed);
    std::sort(expected.begin(), expected.end());
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(rates[i], expected[i], 0.03 * expected[i]) << i;
    EXPECT_NEAR(rates[0], expected[0], 0.005 * expected[0]);
}

// Of loads that change slowly the vibrations are the static response, all together.
TEST(VibrationModes, TogetherAnswerAsTheStaticModesDo) {
    std::mt19937 random(1);
    const ReducedModel& model = rod().reduced.model;
    for (int i = 0; i < 10; ++i) {
        const auto loads = randomPush(*rod().solid, 0.02, random);
        ReducedModel::LocalSystem none;
        const StruckModes struck = model.struckModes(loads, std::numeric_limits<double>::infinity(), none);
        ASSERT_FALSE(struck.empty());
        const double energy = valueOf(model.respond(loads)).strain_energy_j;
        EXPECT_LT(struck.staticEnergy(), 1.001 * energy);
        EXPECT_GT(struck.staticEnergy(), 0.8 * energy);
        const Eigen::VectorXd u = model.vibration(struck.work).cast<double>();
        const double stored = 0.5 * u.dot(blockProduct(rod().stiffness, u));
        EXPECT_NEAR(stored, struck.staticEnergy(), 0.02 * stored);
    }
}

}  // namespace
}  // namespace sherd
