#include "core/stress/stress_lanes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/numerics/arc_tangent.h"
#include "core/stress/near_field.h"
#include "core/stress/principal_stresses.h"
#include "core/stress/surface_traction.h"

namespace sherd {
namespace {

constexpr int lanes = PlaceLanes::count;

class StressInLanes : public testing::Test {
  protected:
    double any() { return uniform_(random_); }
    Vec3 anyVector() { return {any(), any(), any()}; }

    void fill(StressLanes& stress) {
        for (auto& lane : stress.s)
            for (double& value : lane) value = any();
    }

    std::mt19937_64 random_{3};
    std::uniform_real_distribution<double> uniform_{-1, 1};
};

TEST(ArcTangent, IsThatOfTheLibrary) {
    EXPECT_EQ(arcTangent(0), 0);
    for (double x = 1e-6; x < 1e6; x *= 1.01) EXPECT_NEAR(arcTangent(x) / std::atan(x), 1, 5e-16);
}

/// Places on both sides of the plane, and all of them behind it, where no share is asked for, or far before.
TEST_F(StressInLanes, OfANearFieldIsThatOfEachPlace) {
    for (int i = 0; i < 600; ++i) {
        const double reach = std::pow(10.0, any());  // inside the disc, about it, and where it is a point
        const bool all_behind = i % 3 == 1, far_before = i % 3 == 2 && i % 4 == 0;
        const ContactDisc disc{anyVector(), anyVector().normalized(), 0.3, anyVector(), i % 2 == 1};
        const NearField field({disc}, 0.2);
        PlaceLanes at;
        Vec3 places[lanes];
        for (int l = 0; l < lanes; ++l) {
            places[l] = disc.centre + reach * anyVector();
            const double depth = disc.inward.dot(places[l] - disc.centre);
            if (l == 0) places[l] -= depth * disc.inward;  // on the plane
            if (all_behind && depth < 0) places[l] -= 2 * depth * disc.inward;
            if (far_before) places[l] = disc.centre - reach * (disc.inward + 0.1 * anyVector());
            for (int d = 0; d < 3; ++d) at.x[d][l] = places[l][d];
        }
        StressLanes sum = {};
        field.addStressAt(at, sum);
        for (int l = 0; l < lanes; ++l)
            EXPECT_LT((sum.at(l) - toSymmetricTensor(field.stressAt(places[l]))).cwiseAbs().maxCoeff(),
                      1e-11);
    }
}

TEST_F(StressInLanes, TakesTheTractionOfASurface) {
    const Elasticity elasticity(Material::ceramic());
    for (int i = 0; i < 100; ++i) {
        StressLanes stress;
        fill(stress);
        const StressLanes raw = stress;
        SurfaceLanes surface;
        Vec3 normals[lanes], tractions[lanes];
        for (int l = 0; l < lanes; ++l) {
            normals[l] = l == 0 ? Vec3(Vec3::Zero()) : anyVector();
            tractions[l] = anyVector();
            surface.is_known[l] = l > 1 ? 1 : 0;
            for (int d = 0; d < 3; ++d) {
                surface.normal[d][l] = normals[l][d];
                surface.traction_pa[d][l] = tractions[l][d];
            }
        }
        applyTraction(surface, elasticity, stress);
        for (int l = 0; l < 2; ++l) EXPECT_EQ(stress.at(l), raw.at(l));
        for (int l = 2; l < lanes; ++l) {
            const SymmetricTensor expected =
                withTraction(raw.at(l), normals[l].normalized(), tractions[l], elasticity);
            EXPECT_LT((stress.at(l) - expected).cwiseAbs().maxCoeff(), 1e-14);
        }
    }
}

TEST_F(StressInLanes, IsWithinItsPrincipalBounds) {
    double closest = 1;
    for (int i = 0; i < 5000; ++i) {
        StressLanes stress;
        fill(stress);
        for (int k = 0; k < 6; ++k) stress.s[k][0] = k < 3 ? 0.7 : 0;  // the same in all directions
        for (int k = 0; k < 6; ++k) stress.s[k][1] = k < 2 ? 1 : 0;    // of two equal tensions
        for (int k = 0; k < 6; ++k) stress.s[k][2] = 0;
        PlaceLanes::Lane smallest, largest;
        boundPrincipal(stress, smallest, largest);
        for (int l = 0; l < lanes; ++l) {
            const PrincipalStresses principal = principalStresses(stress.at(l));
            EXPECT_GE(largest[l], std::max(0.0, principal.largest));
            EXPECT_LE(smallest[l], std::min(0.0, principal.smallest));
            EXPECT_LE(largest[l] - std::max(0.0, principal.largest), 0.03 * 2 * stress.at(l).norm());
            closest = std::min(closest, largest[l] - principal.largest);
        }
    }
    EXPECT_LT(closest, 1e-3);
}

}  // namespace
}  // namespace sherd
