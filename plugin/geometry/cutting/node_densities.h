#pragma once

#include <algorithm>
#include <vector>

namespace sherd {

/// What each node of a lattice knows of the labels around it: a density each. One linked list a node, the
/// latest entry first.
class NodeDensities {
  public:
    struct Entry {
        int label;
        double value;  ///< part of the space around the node that the label fills, 1 about where it is alone
        int next;      // -1: the last of its node
    };

    explicit NodeDensities(std::size_t node_count = 0) : first_(node_count, -1) {}

    /// Adds to the entry of a label, which is made if there is none.
    void add(int node, int label, double value) {
        for (int e = first_[node]; e >= 0; e = entries_[e].next)
            if (entries_[e].label == label) {
                entries_[e].value += value;
                return;
            }
        entries_.push_back({label, value, first_[node]});
        first_[node] = static_cast<int>(entries_.size()) - 1;
    }

    /// The largest value that a label has at a node (it may have several entries, of clusters that were
    /// merged), or 0.
    double largest(int node, int label) const {
        double most = 0;
        for (int e = first_[node]; e >= 0; e = entries_[e].next)
            if (entries_[e].label == label) most = std::max(most, entries_[e].value);
        return most;
    }

    /// Calls visit(entry) for each entry of a node; it may be changed.
    template <class Visit>
    void forEach(int node, const Visit& visit) {
        for (int e = first_[node]; e >= 0; e = entries_[e].next) visit(entries_[e]);
    }

    int nodeCount() const { return static_cast<int>(first_.size()); }

  private:
    std::vector<int> first_;  // #nodes, or -1
    std::vector<Entry> entries_;
};

}  // namespace sherd
