#include "core/mlpg/particle_forms/centred_fit.h"

#include <gtest/gtest.h>

#include <vector>

namespace sherd {
namespace {

double fitAt(const std::vector<Vec3>& points, const Vec3& x, int expected_rank, const Vec3& slope) {
    CentredFit fit;
    for (size_t i = 0; i < points.size(); ++i) fit.add(points[i], 1.0 + 0.1 * static_cast<double>(i));
    EXPECT_TRUE(fit.finish(1e-3));
    EXPECT_EQ(fit.rank(), expected_rank);
    double value = 0;
    for (size_t i = 0; i < points.size(); ++i)
        value += fit.factorAt(x, points[i], 1.0 + 0.1 * static_cast<double>(i)) * (2 + slope.dot(points[i]));
    return value;
}

TEST(CentredFit, ReproducesWhatThePointsDetermine) {
    const Vec3 far(100, -200, 50), x = far + Vec3(0.3, 0.4, 0.5), slope(1, 2, -3);
    const std::vector<Vec3> solid = {far, far + Vec3(1, 0, 0), far + Vec3(0, 1, 0), far + Vec3(0, 0, 1)};
    EXPECT_NEAR(fitAt(solid, x, 3, slope), 2 + slope.dot(x), 1e-10);
    const std::vector<Vec3> plane = {far, far + Vec3(1, 0, 0), far + Vec3(0, 1, 0)};
    EXPECT_NEAR(fitAt(plane, x, 2, slope), 2 + slope.dot(far + Vec3(0.3, 0.4, 0)), 1e-10);
    EXPECT_NEAR(fitAt({far}, x, 0, slope), 2 + slope.dot(far), 1e-12);
}

TEST(CentredFit, NothingToFit) {
    EXPECT_FALSE(CentredFit().finish(1e-3));
}

}  // namespace
}  // namespace sherd
