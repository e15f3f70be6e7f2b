#include <gtest/gtest.h>
#include <sherd/strength_field.h>

#include "support/shapes.h"

namespace {

using namespace sherd;

/// A cube of edge 2 about the origin, grey by height: black below, white above.
TriangleMesh paintedCube() {
    TriangleMesh cube = shapes::box(Vec3(-1, -1, -1), Vec3(1, 1, 1));
    for (const Vec3& v : cube.vertices) cube.colours.push_back(Vec3::Constant((v.z() + 1) / 2));
    return cube;
}

TEST(StrengthFromColours, GoesFromBlackToWhiteAlongTheSurface) {
    const auto field = strengthFromColours(paintedCube(), 0.2, 3.2);
    ASSERT_TRUE(field.ok()) << field.error();
    for (const double z : {-1.0, -0.4, 0.0, 0.7, 1.0}) {
        const double expected = 0.2 + 3 * (z + 1) / 2;
        EXPECT_NEAR(field.value()(Vec3(1, 0.3, z)), expected, 1e-12);
        EXPECT_NEAR(field.value()(Vec3(0.99, 0.1, 0.98 * z)), 0.2 + 3 * (0.98 * z + 1) / 2, 1e-9)
            << "just inside";
    }
    EXPECT_NEAR(field.value()(Vec3(0.1, 0.2, 5)), 3.2, 1e-12);
}

TEST(StrengthFromColours, WhatIsMissingIsNamed) {
    EXPECT_EQ(strengthFromColours(shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 1)), 1, 2).error(),
              "The mesh has no vertex colours; give its vertices red, green and blue after x, y and z.");
    EXPECT_EQ(strengthFromColours(paintedCube(), 0, 2).error(),
              "The strength of black or white parts is not above 0 and finite.");
}

}  // namespace
