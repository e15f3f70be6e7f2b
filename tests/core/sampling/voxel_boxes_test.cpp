#include "core/sampling/voxel_boxes.h"

#include <gtest/gtest.h>

#include "core/sampling/sampling_support.h"
#include "support/shapes.h"

namespace {

using namespace sherd;

Discretisation block(int nx, int ny, int nz) {
    Discretisation solid;
    const Vec3 size(1, 2, 3);
    solid.cell_size = size;
    solid.grid_origin = Vec3(10, 0, 0);
    for (int z = 0; z < nz; ++z)
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) {
                const Vec3 centre = solid.grid_origin + Vec3(x + 0.5, y + 0.5, z + 0.5).cwiseProduct(size);
                const Mat3 second = size.cwiseAbs2().asDiagonal();
                solid.voxels.push_back({{x, y, z}, static_cast<int>(solid.cells.size()), 1.0});
                solid.cells.push_back({{size.prod(), centre, size.prod() / 12 * second}, 0});
            }
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
    Discretisation solid = block(5, 1, 1);
    solid.voxels[4].fill = 0.3;
    const std::vector<Box> boxes = mergedBoxes(solid, {1, 1, 1, 1, 1});
    ASSERT_EQ(boxes.size(), 1u);
    EXPECT_NEAR(boxes.front().half_extents.x(), 0.5 * 4.3, 1e-12) << "it reaches into the half-empty one";
    EXPECT_NEAR(boxes.front().centre.x(), 10 + 0.5 * 4.3, 1e-12);
    EXPECT_EQ(mergedBoxes(solid, {0, 0, 0, 0, 1}).size(), 1u);
    EXPECT_TRUE(mergedBoxes(solid, {0, 0, 0, 0, 0}).empty());
}

TEST(VoxelBoxes, DoNotReachIntoWhatIsAnotherPiece) {
    Discretisation solid = block(5, 2, 1);
    solid.voxels[4].fill = solid.voxels[9].fill = 0.3;
    const std::vector<Box> lower = mergedBoxes(solid, {1, 1, 1, 1, 1, 0, 0, 0, 0, 0});
    ASSERT_EQ(lower.size(), 1u);
    EXPECT_EQ(lower.front().centre.y() + lower.front().half_extents.y(), 2);
    EXPECT_EQ(lower.front().centre.x() + lower.front().half_extents.x(), 14)
        << "the other piece is beside it";
}

// A pane lies where it is, however the grid of the sampling cuts it, and bars and blocks do too.
TEST(VoxelBoxes, FollowThinSolidsWhereverTheGridCutsThem) {
    for (const double spacing : {0.013, 0.017, 0.025, 0.04})
        for (const Vec3& size : {Vec3(0.3, 0.2, 0.01), Vec3(0.01, 0.012, 0.4), Vec3(0.1, 0.12, 0.09)})
            for (const double shift : {0.0, 0.0021, 0.0057}) {
                SCOPED_TRACE(testing::Message() << spacing << " " << size.transpose() << " " << shift);
                const Vec3 low = -0.5 * size + Vec3::Constant(shift);
                const Discretisation solid = sampled(shapes::box(low, low + size), spacing);
                const auto boxes = mergedBoxes(solid, std::vector<char>(solid.voxels.size(), 1));
                Eigen::AlignedBox3d all;
                double volume = 0;
                for (const Box& b : boxes) {
                    all.extend(b.centre - b.half_extents);
                    all.extend(b.centre + b.half_extents);
                    volume += 8 * b.half_extents.prod();
                }
                const Vec3 below = all.min() - low, above = all.max() - (low + size);
                EXPECT_LT(below.cwiseAbs().maxCoeff(), 0.02 * size.minCoeff()) << below.transpose();
                EXPECT_LT(above.cwiseAbs().maxCoeff(), 0.02 * size.minCoeff()) << above.transpose();
                EXPECT_NEAR(volume / size.prod(), 1, 0.02);
            }
}

}  // namespace
