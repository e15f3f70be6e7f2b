#include "core/linear_algebra/elimination_tree.h"

#include <numeric>

namespace sherd {
namespace {

std::vector<int> inverse(const std::vector<int>& order) {
    std::vector<int> place(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<int>(k);
    return place;
}

std::vector<int> parents(const BlockGraph& graph, const std::vector<int>& order,
                         const std::vector<int>& place) {
    const int count = graph.size();
    std::vector<int> parent(count, -1), ancestor(count, -1);
    for (int column = 0; column < count; ++column)
        for (int e = graph.starts[order[column]]; e < graph.starts[order[column] + 1]; ++e)
            for (int i = place[graph.neighbours[e]]; i >= 0 && i < column;) {
                const int next = ancestor[i];
                ancestor[i] = column;
                if (next < 0) parent[i] = column;
                i = next;
            }
    return parent;
}

/// Columns so that each comes right behind all below it.
std::vector<int> postorder(const std::vector<int>& parent) {
    const int count = static_cast<int>(parent.size());
    std::vector<int> first_child(count, -1), next_sibling(count, -1), post, stack;
    for (int column = count - 1; column >= 0; --column) {
        if (parent[column] < 0) continue;
        next_sibling[column] = first_child[parent[column]];
        first_child[parent[column]] = column;
    }
    post.reserve(count);
    for (int root = 0; root < count; ++root) {
        if (parent[root] >= 0) continue;
        stack.assign(1, root);
        while (!stack.empty()) {
            const int column = stack.back();
            const int child = first_child[column];
            if (child >= 0) {
                first_child[column] = next_sibling[child];
                stack.push_back(child);
            } else {
                post.push_back(column);
                stack.pop_back();
            }
        }
    }
    return post;
}

/// Counts by the leaves of row subtrees; columns in postorder.
class ColumnCounts {
  public:
    ColumnCounts(const BlockGraph& graph, const EliminationTree& tree, const std::vector<int>& place)
        : first_(tree.order.size(), -1),
          largest_first_(first_),
          previous_leaf_(first_),
          ancestor_(tree.order.size()) {
        const int count = static_cast<int>(tree.order.size());
        counts_.resize(count);
        for (int k = 0; k < count; ++k) {
            counts_[k] = first_[k] < 0 ? 1 : 0;
            for (int j = k; j >= 0 && first_[j] < 0; j = tree.parent[j]) first_[j] = k;
        }
        std::iota(ancestor_.begin(), ancestor_.end(), 0);
        for (int column = 0; column < count; ++column) {
            const int parent = tree.parent[column];
            if (parent >= 0) --counts_[parent];
            for (int e = graph.starts[tree.order[column]]; e < graph.starts[tree.order[column] + 1]; ++e)
                addLeaf(place[graph.neighbours[e]], column);
            if (parent >= 0) ancestor_[column] = parent;
        }
        for (int column = 0; column < count; ++column)
            if (tree.parent[column] >= 0) counts_[tree.parent[column]] += counts_[column];
    }

    std::vector<int> counts() && { return std::move(counts_); }

  private:
    /// Takes note of `column` if it is a leaf of the subtree of columns that reach `row`.
    void addLeaf(int row, int column) {
        if (row <= column || first_[column] <= largest_first_[row]) return;
        largest_first_[row] = first_[column];
        const int previous = previous_leaf_[row];
        previous_leaf_[row] = column;
        ++counts_[column];
        if (previous < 0) return;
        int common = previous;
        while (common != ancestor_[common]) common = ancestor_[common];
        for (int s = previous; s != common;) {
            const int up = ancestor_[s];
            ancestor_[s] = common;
            s = up;
        }
        --counts_[common];
    }

    std::vector<int> first_, largest_first_, previous_leaf_, ancestor_, counts_;
};

}  // namespace

double EliminationTree::blocks() const {
    return std::accumulate(counts.begin(), counts.end(), 0.0);
}

EliminationTree eliminationTree(const BlockGraph& graph, const std::vector<int>& order) {
    const std::vector<int> parent = parents(graph, order, inverse(order)), post = postorder(parent);
    const std::vector<int> number = inverse(post);
    EliminationTree tree;
    tree.order.resize(order.size());
    tree.parent.resize(order.size());
    for (std::size_t k = 0; k < post.size(); ++k) {
        tree.order[k] = order[post[k]];
        tree.parent[k] = parent[post[k]] < 0 ? -1 : number[parent[post[k]]];
    }
    tree.counts = ColumnCounts(graph, tree, inverse(tree.order)).counts();
    return tree;
}

}  // namespace sherd
