#include "core/sampling/voxel_boxes.h"

#include <algorithm>

#include "core/sampling/box_fit.h"

namespace sherd {

namespace {

using Index = Eigen::Vector3i;

/// A block of voxels, from one corner to the other, both in it.
struct Block {
    Index low, high;
};

/// Calls visit(v) for the voxels of a block, -1 where there is none, as long as it returns true.
template <class Visit>
bool visitBlock(const VoxelIndex& index, const Index& low, const Index& high, const Visit& visit) {
    for (int z = low.z(); z <= high.z(); ++z)
        for (int y = low.y(); y <= high.y(); ++y)
            for (int x = low.x(); x <= high.x(); ++x)
                if (!visit(index.at({x, y, z}))) return false;
    return true;
}

/// Merges voxels (`voxels`: ascending; `uncovered`: 1 for these, all 0 after).
std::vector<Block> mergedBlocks(const Discretisation& solid, const VoxelIndex& index,
                                const std::vector<int>& voxels, std::vector<char>& uncovered) {
    const auto is_uncovered = [&](int v) { return v >= 0 && uncovered[v]; };
    std::vector<Block> blocks;
    for (const int first : voxels) {
        if (!uncovered[first]) continue;
        const Index low = solid.voxels[first].index;
        Index high = low;
        for (int axis = 0; axis < 3; ++axis) {
            while (true) {
                Index slice_low = low, slice_high = high;
                slice_low[axis] = slice_high[axis] = high[axis] + 1;
                if (!visitBlock(index, slice_low, slice_high, is_uncovered)) break;
                ++high[axis];
            }
        }
        visitBlock(index, low, high, [&](int v) {
            uncovered[v] = 0;
            return true;
        });
        blocks.push_back({low, high});
    }
    return blocks;
}

}  // namespace

std::vector<std::vector<Box>> boxesOfPieces(const Discretisation& solid, const std::vector<int>& owner,
                                            int count) {
    constexpr double half_solid = 0.5;
    std::vector<std::vector<int>> wanted(count);
    for (std::size_t v = 0; v < owner.size(); ++v)
        if (owner[v] >= 0) wanted[owner[v]].push_back(static_cast<int>(v));
    const VoxelIndex index(solid);
    std::vector<char> is_covered(owner.size(), 0), uncovered(owner.size(), 0);
    std::vector<std::vector<Box>> boxes(count);
    for (int piece = 0; piece < count; ++piece) {
        double fullest = 0;
        for (const int v : wanted[piece]) fullest = std::max(fullest, solid.voxels[v].fill);
        const double least = half_solid * fullest;  // no voxel of a thin wall may be half solid
        for (const int v : wanted[piece]) is_covered[v] = uncovered[v] = solid.voxels[v].fill >= least;
        const BoxFit fit(solid, index, {owner, is_covered, piece});
        for (const Block& block : mergedBlocks(solid, index, wanted[piece], uncovered))
            boxes[piece].push_back(fit.fit(block.low, block.high));
    }
    return boxes;
}

std::vector<Box> mergedBoxes(const Discretisation& solid, const std::vector<char>& wanted) {
    std::vector<int> owner(wanted.size());
    std::transform(wanted.begin(), wanted.end(), owner.begin(), [](char is_wanted) { return is_wanted - 1; });
    return boxesOfPieces(solid, owner, 1).front();
}

}  // namespace sherd
