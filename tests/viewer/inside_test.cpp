#include "viewer/inside.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scenes/box_mesh.h"

namespace {

TEST(InsideTest, KnowsTheInsideOfABoxAlsoOverItsEdges) {
    const sherd::TriangleMesh box = demo::boxMesh({demo::Vec3(2, 2, 2), 0.5});
    const demo::InsideTest inside(box);
    for (double x = -1.25; x < 1.3; x += 0.25)
        for (double y = -1.25; y < 1.3; y += 0.25)
            for (double z : {-1.1, -0.9, 0.0, 0.9, 1.1}) {
                if (std::abs(x) == 1 || std::abs(y) == 1) continue;  // on a side: either is right
                const bool expected = std::abs(x) < 1 && std::abs(y) < 1 && std::abs(z) < 1;
                EXPECT_EQ(inside.contains({x, y, z}), expected) << x << " " << y << " " << z;
            }
}

}  // namespace
