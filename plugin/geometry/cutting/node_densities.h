#pragma once

#include <algorithm>
#include <limits>
#include <vector>

namespace sherd {

/// What each node of a lattice knows of the labels around it: a density each. One linked list a node, the
/// latest entry first; the first of all, which most nodes have alone, is kept by number of the node.
class NodeDensities {
    static constexpr int none = std::numeric_limits<int>::min();  // clusters have numbers below zero

  public:
    struct Entry {
        int label = none;
        int next = -1;  // of the later ones; -1: the last of them
        double value =
            0;  ///< part of the space around the node that the label fills, 1 about where it is alone
    };

    explicit NodeDensities(std::size_t node_count = 0) : nodes_(node_count) {}

    /// Adds to the entry of a label, which is made if there is none.
    void add(int node, int label, double value) {
        Node& at = nodes_[node];
        if (at.oldest.label == label) {
            at.oldest.value += value;
            return;
        }
        if (at.oldest.label == none) {
            at.oldest = {label, -1, value};
            return;
        }
        for (int e = at.latest; e >= 0; e = later_[e].next)
            if (later_[e].label == label) {
                later_[e].value += value;
                return;
            }
        later_.push_back({label, at.latest, value});
        at.latest = static_cast<int>(later_.size()) - 1;
    }

    /// The largest value that a label has at a node (it may have several entries, of clusters that were
    /// merged), or 0.
    double largest(int node, int label) const {
        const Node& at = nodes_[node];
        double most = at.oldest.label == label ? std::max(0.0, at.oldest.value) : 0;
        for (int e = at.latest; e >= 0; e = later_[e].next)
            if (later_[e].label == label) most = std::max(most, later_[e].value);
        return most;
    }

    /// Calls visit(entry) for each entry of a node; it may be changed.
    template <class Visit>
    void forEach(int node, const Visit& visit) {
        Node& at = nodes_[node];
        for (int e = at.latest; e >= 0; e = later_[e].next) visit(later_[e]);
        if (at.oldest.label != none) visit(at.oldest);
    }

    int nodeCount() const { return static_cast<int>(nodes_.size()); }

  private:
    struct Node {
        Entry oldest;
        int latest = -1;  // in `later_`
    };
    std::vector<Node> nodes_;
    std::vector<Entry> later_;
};

}  // namespace sherd
