#include "core/sampling/voxel_boxes.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "core/sampling/box_fit.h"

namespace sherd {

namespace {

using Index = Eigen::Vector3i;

/// The wanted voxels that no box covers yet, in ascending order of (z, y, x).
class Uncovered {
  public:
    void add(const Index& i) { voxels_.insert(key(i)); }
    bool empty() const { return voxels_.empty(); }
    Index first() const {
        const auto& [z, y, x] = *voxels_.begin();
        return {x, y, z};
    }
    /// Whether all voxels of the block [low, high] are uncovered.
    bool holds(const Index& low, const Index& high) const {
        return visit(low, high, [&](const Index& i) { return voxels_.count(key(i)) > 0; });
    }
    void take(const Index& low, const Index& high) {
        visit(low, high, [&](const Index& i) { return voxels_.erase(key(i)) > 0; });
    }

  private:
    using Key = std::tuple<int, int, int>;
    static Key key(const Index& i) { return {i.z(), i.y(), i.x()}; }

    template <class Test>
    static bool visit(const Index& low, const Index& high, const Test& test) {
        for (int z = low.z(); z <= high.z(); ++z)
            for (int y = low.y(); y <= high.y(); ++y)
                for (int x = low.x(); x <= high.x(); ++x)
                    if (!test({x, y, z})) return false;
        return true;
    }

    std::set<Key> voxels_;
};

/// A block of voxels, from one corner to the other, both in it.
struct Block {
    Index low, high;
};

std::vector<Block> mergedBlocks(Uncovered rest) {
    std::vector<Block> blocks;
    while (!rest.empty()) {
        const Index low = rest.first();
        Index high = low;
        for (int axis = 0; axis < 3; ++axis) {
            while (true) {
                Index slice_low = low, slice_high = high;
                slice_low[axis] = slice_high[axis] = high[axis] + 1;
                if (!rest.holds(slice_low, slice_high)) break;
                ++high[axis];
            }
        }
        rest.take(low, high);
        blocks.push_back({low, high});
    }
    return blocks;
}

}  // namespace

std::vector<Box> mergedBoxes(const Discretisation& solid, const std::vector<char>& wanted) {
    constexpr double half_solid = 0.5;
    double fullest = 0;
    for (std::size_t v = 0; v < wanted.size(); ++v)
        if (wanted[v]) fullest = std::max(fullest, solid.voxels[v].fill);
    const double least = half_solid * fullest;  // no voxel of a thin wall may be half solid
    std::vector<char> covered(wanted.size());
    Uncovered rest;
    for (std::size_t v = 0; v < wanted.size(); ++v) {
        covered[v] = wanted[v] && solid.voxels[v].fill >= least;
        if (covered[v]) rest.add(solid.voxels[v].index);
    }
    const BoxFit fit(solid, wanted, covered);
    std::vector<Box> boxes;
    for (const Block& block : mergedBlocks(std::move(rest))) boxes.push_back(fit.fit(block.low, block.high));
    return boxes;
}

}  // namespace sherd
