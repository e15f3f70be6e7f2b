#pragma once

#include <algorithm>
#include <vector>

namespace sherd {

/// What each node of a lattice knows of the labels around it: a density each, the part of the space around
/// the node that the label fills. Where there is one label alone its density is taken as 1.
class NodeDensities {
  public:
    struct Entry {
        int label;
        double value;
    };

    explicit NodeDensities(std::size_t node_count = 0) : nodes_(node_count, {0, 0}) {}

    /// To be called once for a node, if at all.
    void set(int node, const std::vector<Entry>& entries) {
        nodes_[node] = {static_cast<int>(entries_.size()), static_cast<int>(entries.size())};
        entries_.insert(entries_.end(), entries.begin(), entries.end());
    }

    /// The largest value that a label has at a node (it may have several entries, of clusters that were
    /// merged), or 0.
    double largest(int node, int label) const {
        double most = 0;
        for (int e = nodes_[node].first; e < nodes_[node].first + nodes_[node].count; ++e)
            if (entries_[e].label == label) most = std::max(most, entries_[e].value);
        return most;
    }

  private:
    struct Range {
        int first, count;
    };
    std::vector<Range> nodes_;
    std::vector<Entry> entries_;
};

}  // namespace sherd
