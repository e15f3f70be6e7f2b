#include <gtest/gtest.h>
#include <sherd/stress_model.h>
#include <sherd/triangle_mesh.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/case_reference.h"

namespace {

using namespace sherd;

const std::string folder = std::string(SHERD_TEST_DATA) + "/cases/bracket_fillet";

/// Two legs whose ends are pulled apart, with a fillet of 4 mm between them.
class Bracket : public ::testing::Test {
  protected:
    static StressModel model(const Settings& settings) {
        Material material;
        material.youngs_modulus_pa = 60e9;
        material.poisson_ratio = 0.22;
        material.density_kg_m3 = 2400;
        auto mesh = readObj(folder + "/surface.obj");
        if (!mesh) throw std::runtime_error(mesh.error());
        auto model = StressModel::make(mesh.value(), material, settings, {});
        if (!model) throw std::runtime_error(model.error());
        return std::move(model).value();
    }
    static std::vector<SymmetricTensor> solve(const StressModel& model, const std::vector<Vec3>& points) {
        SurfaceLoad down{BoxRegion{Vec3(0.1, 0, 0), Vec3(0.1, 0.02, 0.03)}};
        SurfaceLoad left{BoxRegion{Vec3(0, 0.1, 0), Vec3(0.02, 0.1, 0.03)}};
        down.force_n = Vec3(0, -100, 0);
        left.force_n = Vec3(-100, 0, 0);
        auto field = model.solve({down, left}, points);
        if (!field) throw std::runtime_error(field.error());
        return std::move(field).value().points;
    }
    static Settings rounds(int count) {
        Settings settings;
        settings.stress.resampling_rounds = count;
        return settings;
    }
    static double errorOf(const Settings& settings) {
        const CaseReference reference = readReference(folder + "/reference_surface.csv");
        EXPECT_GT(reference.points.size(), 250u);
        const auto stresses = solve(model(settings), reference.points);
        double difference = 0, norm = 0;
        for (std::size_t i = 0; i < stresses.size(); ++i) {
            difference += std::pow(largestPrincipal(stresses[i]) - reference.largest_principal[i], 2);
            norm += std::pow(reference.largest_principal[i], 2);
        }
        return std::sqrt(difference / norm);
    }
};

// Against quadratic tetrahedra, at 258 points. The loads are far from the fillet, of which a cell is larger.
TEST_F(Bracket, TheFilletIsResampled) {
    const double without = errorOf(rounds(0)), with = errorOf(rounds(2));
    EXPECT_GT(without, 0.2);
    EXPECT_LT(with, 0.12);
}

// The grid of `film` is almost fine enough for it: with an error of 0.1 it would be left at that, 8 % off.
TEST_F(Bracket, FilmResamplesWhatIsAlmostKnown) {
    EXPECT_LT(errorOf(Settings::forQuality(Quality::film)), 0.03);
}

TEST_F(Bracket, AFurtherSolveOnKeptGridsGivesTheSameBits) {
    const std::vector<Vec3> points = readReference(folder + "/reference_surface.csv").points;
    const StressModel bracket = model(rounds(2));
    const auto first = solve(bracket, points), again = solve(bracket, points);
    ASSERT_EQ(first.size(), points.size());
    ASSERT_EQ(again.size(), points.size());
    ASSERT_FALSE(points.empty());
    for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i], again[i]);
}

}  // namespace
