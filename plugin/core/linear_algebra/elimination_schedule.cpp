#include "core/linear_algebra/elimination_schedule.h"

#include <algorithm>

namespace sherd {
namespace {

/// Of the work, for one subtree; fixed, so that results do not depend on the number of cores.
constexpr double largest_share = 1.0 / 6;

double workOf(const FrontTree& fronts, int front) {
    const double columns = fronts.columns(front), rows = static_cast<double>(fronts.rows[front].size());
    return columns * (columns * columns / 3 + columns * rows + rows * rows);
}

/// The largest sizes of the two stacks while a run's fronts are eliminated in turn.
void measureStacks(const FrontTree& fronts, int block_size, const std::vector<int>& depth,
                   const std::vector<int>& run_of_front, int run, EliminationSchedule::Run& result) {
    const auto sizeOf = [&](int front) {
        const std::size_t rows = fronts.rows[front].size() * static_cast<std::size_t>(block_size);
        return rows * rows;
    };
    std::array<std::size_t, 2> used{0, 0};
    for (const int front : result.fronts) {
        const int own = depth[front] % 2;
        used[own] += sizeOf(front);
        result.stack_sizes[own] = std::max(result.stack_sizes[own], used[own]);
        for (const int child : fronts.children[front])
            if (run_of_front[child] == run) used[1 - own] -= sizeOf(child);
    }
}

}  // namespace

EliminationSchedule::EliminationSchedule(const FrontTree& fronts, int block_size) : depth(fronts.count(), 0) {
    const int count = fronts.count();
    std::vector<double> work(count, 0);
    double all = 0;
    for (int f = 0; f < count; ++f) {
        const double own = workOf(fronts, f);
        all += own;
        work[f] += own;
        if (fronts.parent[f] >= 0) work[fronts.parent[f]] += work[f];
    }
    // From the top down: what is too large is eliminated after its children.
    constexpr int in_top = -1;
    std::vector<int> run_of_front(count, in_top);
    for (int f = count - 1; f >= 0; --f) {
        const int parent = fronts.parent[f];
        if (parent >= 0) depth[f] = depth[parent] + 1;
        if (parent >= 0 && run_of_front[parent] != in_top) {
            run_of_front[f] = run_of_front[parent];
        } else if (work[f] <= largest_share * all) {
            run_of_front[f] = static_cast<int>(subtrees.size());
            subtrees.emplace_back();
        }
    }
    for (int f = 0; f < count; ++f)
        (run_of_front[f] == in_top ? top : subtrees[run_of_front[f]]).fronts.push_back(f);
    for (std::size_t r = 0; r < subtrees.size(); ++r)
        measureStacks(fronts, block_size, depth, run_of_front, static_cast<int>(r), subtrees[r]);
    measureStacks(fronts, block_size, depth, run_of_front, in_top, top);
    // The dearest first, so that no core waits long for the last.
    std::stable_sort(subtrees.begin(), subtrees.end(), [&](const Run& a, const Run& b) {
        return work[a.fronts.back()] > work[b.fronts.back()];
    });
}

}  // namespace sherd
