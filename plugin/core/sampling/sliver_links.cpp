#include "core/sampling/sliver_links.h"

#include <algorithm>
#include <tuple>

#include "core/numerics/union_find.h"

namespace sherd {
namespace {

constexpr double smallest_component = 0.25;  // of a cell: less cannot determine its functions

/// Nearest part of another component around a part; of those in equally distant cells the fullest.
class NearestOther {
  public:
    explicit NearestOther(const CellParts& cells) : cells_(cells) {}

    void look(int from, UnionFind& sets) {
        const int component = sets.root(from);
        for (int k = -1; k <= 1; ++k)
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i) consider(from, {i, j, k}, component, sets);
    }

    bool found() const { return link_[1] >= 0; }
    const std::array<int, 2>& link() const { return link_; }

  private:
    void consider(int from, const Eigen::Vector3i& step, int component, UnionFind& sets) {
        const Eigen::Vector3i cell = cells_.parts[from].cell + step;
        if ((cell.array() < 0).any() || (cell.array() >= cells_.count.array()).any()) return;
        const int index = cells_.cellIndex(cell);
        for (int other = cells_.first_part[index]; other < cells_.first_part[index + 1]; ++other) {
            if (sets.root(other) == component) continue;
            const auto order = std::make_tuple(step.squaredNorm(), -cells_.parts[other].fill, other, from);
            if (found() && order >= best_) continue;
            best_ = order;
            link_ = {from, other};
        }
    }

    const CellParts& cells_;
    std::tuple<int, double, int, int> best_;
    std::array<int, 2> link_ = {-1, -1};
};

}  // namespace

std::vector<std::array<int, 2>> sliverLinks(const CellParts& cells,
                                            const std::vector<std::array<int, 2>>& links) {
    const int part_count = static_cast<int>(cells.parts.size());
    UnionFind sets(part_count);
    for (const auto& [a, b] : links) sets.unite(a, b);
    std::vector<double> fill(part_count, 0.0);
    std::vector<std::vector<int>> members(part_count);
    for (int part = 0; part < part_count; ++part) fill[sets.root(part)] += cells.parts[part].fill;
    std::vector<int> slivers;  // their roots
    for (int part = 0; part < part_count; ++part)
        if (fill[sets.root(part)] < smallest_component) members[sets.root(part)].push_back(part);
    for (int part = 0; part < part_count; ++part)
        if (!members[part].empty()) slivers.push_back(part);
    std::stable_sort(slivers.begin(), slivers.end(), [&](int a, int b) { return fill[a] < fill[b]; });

    std::vector<std::array<int, 2>> added;
    for (const int sliver : slivers) {
        NearestOther nearest(cells);
        for (const int part : members[sliver]) nearest.look(part, sets);
        if (!nearest.found()) continue;
        added.push_back(nearest.link());
        sets.unite(nearest.link()[0], nearest.link()[1]);
    }
    return added;
}

}  // namespace sherd
