#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace sherd {

/// Disjoint sets of 0 .. count-1. The root of a set is its lowest member, whatever the order of the unions.
class UnionFind {
  public:
    explicit UnionFind(int count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

    int root(int a) {
        while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
        return a;
    }

    void unite(int a, int b) {
        a = root(a), b = root(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<int> parent_;
};

}  // namespace sherd
