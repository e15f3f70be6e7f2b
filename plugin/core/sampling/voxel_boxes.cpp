#include "core/sampling/voxel_boxes.h"

#include <algorithm>
#include <set>
#include <tuple>

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

Box boxOf(const Discretisation& solid, const Index& low, const Index& high) {
    const Vec3 from = solid.grid_origin + low.cast<double>().cwiseProduct(solid.cell_size);
    const Vec3 to =
        solid.grid_origin + (high.array() + 1).matrix().cast<double>().cwiseProduct(solid.cell_size);
    return {0.5 * (from + to), 0.5 * (to - from)};
}

}  // namespace

std::vector<Box> mergedBoxes(const Discretisation& solid, const std::vector<char>& wanted) {
    constexpr double half_solid = 0.5;
    double fullest = 0;
    for (std::size_t v = 0; v < wanted.size(); ++v)
        if (wanted[v]) fullest = std::max(fullest, solid.voxels[v].fill);
    const double least = std::min(half_solid, fullest);
    Uncovered rest;
    for (std::size_t v = 0; v < wanted.size(); ++v)
        if (wanted[v] && solid.voxels[v].fill >= least) rest.add(solid.voxels[v].index);
    std::vector<Box> boxes;
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
        boxes.push_back(boxOf(solid, low, high));
    }
    return boxes;
}

}  // namespace sherd
