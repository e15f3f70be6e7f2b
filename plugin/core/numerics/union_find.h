#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace sherd {

/// Disjoint sets of the items 0 .. count - 1 with path halving. The root of a set is the member that stands
/// for it.
class UnionFind {
  public:
    explicit UnionFind(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

    int root(int item) {
        while (parent_[item] != item) item = parent_[item] = parent_[parent_[item]];
        return item;
    }

    bool isRoot(int item) const { return parent_[item] == item; }

    /// Unites two sets; the lower of their roots is the new one. With this union alone the root of a set is
    /// its lowest member, whatever the order of the unions.
    void unite(int a, int b) {
        a = root(a), b = root(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

    /// Unites two sets; the root of `target` stays.
    void uniteInto(int target, int item) { parent_[root(item)] = root(target); }

    /// The root of every item.
    std::vector<int> roots() {
        std::vector<int> result(parent_.size());
        for (std::size_t i = 0; i < result.size(); ++i) result[i] = root(static_cast<int>(i));
        return result;
    }

  private:
    std::vector<int> parent_;
};

}  // namespace sherd
