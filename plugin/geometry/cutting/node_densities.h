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

    /// Nodes that follow each other, each with its entries, for `append`.
    struct Part {
        std::vector<int> nodes, counts;
        std::vector<Entry> entries;
        void add(int node, const std::vector<Entry>& more) {
            nodes.push_back(node);
            counts.push_back(static_cast<int>(more.size()));
            entries.insert(entries.end(), more.begin(), more.end());
        }
    };
    void append(const Part& part) {
        int first = static_cast<int>(entries_.size());
        for (std::size_t n = 0; n < part.nodes.size(); first += part.counts[n++])
            nodes_[part.nodes[n]] = {first, part.counts[n]};
        entries_.insert(entries_.end(), part.entries.begin(), part.entries.end());
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
