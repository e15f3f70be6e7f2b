#include "core/sampling/voxel_boxes.h"

#include <gtest/gtest.h>

namespace {

using namespace sherd;

Discretisation block(int nx, int ny, int nz) {
    Discretisation solid;
    solid.cell_size = Vec3(1, 2, 3);
    solid.grid_origin = Vec3(10, 0, 0);
    for (int z = 0; z < nz; ++z)
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) solid.voxels.push_back({{x, y, z}, 0, 1.0});
    return solid;
}

TEST(VoxelBoxes, AFullBlockIsOneBox) {
    const Discretisation solid = block(4, 3, 2);
    const auto boxes = mergedBoxes(solid, std::vector<char>(24, 1));
    ASSERT_EQ(boxes.size(), 1u);
    EXPECT_TRUE(boxes[0].centre.isApprox(Vec3(12, 3, 3)));
    EXPECT_TRUE(boxes[0].half_extents.isApprox(Vec3(2, 3, 3)));
}

TEST(VoxelBoxes, BoxesCoverTheWantedVoxelsOnce) {
    const Discretisation solid = block(7, 5, 4);
    std::vector<char> wanted(solid.voxels.size());
    int count = 0;
    for (std::size_t v = 0; v < wanted.size(); ++v) count += wanted[v] = (v * 2654435761u >> 7) % 3 != 0;
    double volume = 0;
    for (const Box& b : mergedBoxes(solid, wanted)) volume += 8 * b.half_extents.prod();
    EXPECT_NEAR(volume, 6.0 * count, 1e-9);
}

TEST(VoxelBoxes, HalfEmptyVoxelsAreLeftOutUnlessThereIsNothingElse) {
    Discretisation solid = block(2, 1, 1);
    solid.voxels[1].fill = 0.3;
    EXPECT_EQ(mergedBoxes(solid, {1, 1}).front().half_extents.x(), 0.5);
    EXPECT_EQ(mergedBoxes(solid, {0, 1}).size(), 1u);
    EXPECT_TRUE(mergedBoxes(solid, {0, 0}).empty());
}

}  // namespace
