#include "core/sampling/cell_parts.h"

#include <gtest/gtest.h>

#include "core/sampling/sample_solid.h"
#include "support/shapes.h"

namespace sherd {
namespace {

// Volume, centre and second moment of all parts against the box's own: V, V c, V (c c^T + R diag(a^2/12)
// R^T).
TEST(CellParts, MomentsAddUpToTheSolid) {
    const Mat3 rotation =
        (Eigen::AngleAxisd(0.4, Vec3::UnitX()) * Eigen::AngleAxisd(0.7, Vec3::UnitY())).toRotationMatrix();
    const Vec3 offset(0.3, -0.2, 0.1), size(1, 0.6, 0.4);
    SamplingSettings settings;
    settings.moment_order = 4;
    const auto sampled = sampleSolid(shapes::moved(shapes::slab(size), rotation, offset), 0.13, settings);
    ASSERT_TRUE(sampled.ok()) << sampled.error();
    const CellParts& solid = sampled.value().parts;
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

}  // namespace
}  // namespace sherd
