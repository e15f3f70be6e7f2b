#include "core/linear_algebra/front_tree.h"

#include <algorithm>
#include <array>

namespace sherd {
namespace {

/// Zeros that a front of so many unknowns may store, of its entries: a front is as dear as its calls when it
/// is small, and as its arithmetic when it is large.
struct Allowance {
    int unknowns;
    double zeros;
};
constexpr std::array<Allowance, 4> allowances = {{{12, 1.0}, {48, 0.6}, {144, 0.15}, {400, 0.05}}};

double allowedZeros(int unknowns) {
    for (const Allowance& allowance : allowances)
        if (unknowns <= allowance.unknowns) return allowance.zeros;
    return 0.02;
}

/// Columns of a front before and while fronts are joined.
struct Group {
    std::vector<int> columns;  // ascending
    int rows = 0;              // below them
    int parent = -1;           // group
    double zeros = 0;          // blocks stored that are none of the factor's
    std::vector<int> children;
};

double blocksOf(double columns, double rows) {
    return columns * (columns + 1) / 2 + columns * rows;
}

/// Columns with the same rows below them, each the parent of the one before.
std::vector<Group> groupsOf(const EliminationTree& tree) {
    const int count = static_cast<int>(tree.order.size());
    std::vector<Group> groups;
    std::vector<int> group_of(count);
    for (int k = 0; k < count; ++k) {
        if (k == 0 || tree.parent[k - 1] != k || tree.counts[k - 1] != tree.counts[k] + 1)
            groups.emplace_back();
        groups.back().columns.push_back(k);
        groups.back().rows = tree.counts[k] - 1;
        group_of[k] = static_cast<int>(groups.size()) - 1;
    }
    for (int g = 0; g < static_cast<int>(groups.size()); ++g) {
        const int above = tree.parent[groups[g].columns.back()];
        if (above < 0) continue;
        groups[g].parent = group_of[above];
        groups[group_of[above]].children.push_back(g);
    }
    return groups;
}

/// Joins groups with children of theirs where that stores few zeros, the best first. Joined children are left
/// without columns.
void joinSmall(std::vector<Group>& groups, int block_size) {
    std::vector<std::pair<double, int>> candidates;
    for (Group& group : groups) {
        candidates.clear();
        for (const int c : group.children) {
            const Group& child = groups[c];
            const double own_columns = static_cast<double>(child.columns.size());
            const double more =
                own_columns * (static_cast<double>(group.columns.size()) + group.rows - child.rows);
            candidates.emplace_back(more / blocksOf(own_columns, child.rows), c);
        }
        std::sort(candidates.begin(), candidates.end());
        for (const auto& candidate : candidates) {
            Group& child = groups[candidate.second];
            const double own = static_cast<double>(child.columns.size()),
                         above = static_cast<double>(group.columns.size());
            const double joined = blocksOf(own + above, group.rows);
            const double zeros =
                group.zeros + child.zeros + joined - blocksOf(own, child.rows) - blocksOf(above, group.rows);
            if (zeros > allowedZeros(static_cast<int>(own + above) * block_size) * joined) continue;
            group.zeros = zeros;
            group.columns.insert(group.columns.end(), child.columns.begin(), child.columns.end());
            group.children.insert(group.children.end(), child.children.begin(), child.children.end());
            group.children.erase(std::find(group.children.begin(), group.children.end(), candidate.second));
            child.columns.clear();
        }
        std::sort(group.columns.begin(), group.columns.end());
        std::sort(group.children.begin(), group.children.end());
    }
}

/// The groups that are left, each right behind all below it.
std::vector<int> postorder(const std::vector<Group>& groups) {
    std::vector<int> post;
    const auto visit = [&](const auto& self, int g) -> void {
        for (const int child : groups[g].children) self(self, child);
        post.push_back(g);
    };
    for (int g = 0; g < static_cast<int>(groups.size()); ++g)
        if (groups[g].parent < 0) visit(visit, g);
    return post;
}

}  // namespace

FrontTree::FrontTree(const BlockGraph& graph, const EliminationTree& tree, int block_size) {
    std::vector<Group> groups = groupsOf(tree);
    joinSmall(groups, block_size);
    const std::vector<int> post = postorder(groups);
    const int front_count = static_cast<int>(post.size());
    std::vector<int> front_of_group(groups.size(), -1);
    for (int f = 0; f < front_count; ++f) front_of_group[post[f]] = f;

    first_column.assign(1, 0);
    parent.assign(front_count, -1);
    children.resize(front_count);
    place.resize(tree.order.size());
    for (int f = 0; f < front_count; ++f) {
        for (const int column : groups[post[f]].columns) {
            place[tree.order[column]] = static_cast<int>(order.size());
            order.push_back(tree.order[column]);
        }
        first_column.push_back(static_cast<int>(order.size()));
        for (const int child : groups[post[f]].children) {
            children[f].push_back(front_of_group[child]);
            parent[front_of_group[child]] = f;
        }
        std::sort(children[f].begin(), children[f].end());
    }
    rows.resize(front_count);
    std::vector<int> seen(order.size(), -1);
    for (int f = 0; f < front_count; ++f) {
        const int behind = first_column[f + 1];
        const auto add = [&](int row) {
            if (row < behind || seen[row] == f) return;
            seen[row] = f;
            rows[f].push_back(row);
        };
        rows[f].reserve(groups[post[f]].rows);
        for (const int child : children[f])
            for (const int row : rows[child]) add(row);
        for (int column = first_column[f]; column < behind; ++column)
            for (int e = graph.starts[order[column]]; e < graph.starts[order[column] + 1]; ++e)
                add(place[graph.neighbours[e]]);
        std::sort(rows[f].begin(), rows[f].end());
    }
}

}  // namespace sherd
