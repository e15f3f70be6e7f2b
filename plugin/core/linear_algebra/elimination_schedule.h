#pragma once

#include <array>
#include <cstddef>

#include "core/linear_algebra/front_tree.h"

namespace sherd {

/// Which fronts are eliminated side by side, and what the updates that they leave behind take. An update lies
/// on one of two stacks, that of even or that of odd depth in the tree: so a front's own update grows on one
/// stack while those of its children are still on the other.
struct EliminationSchedule {
    struct Run {
        std::vector<int> fronts;                       ///< ascending
        std::array<std::size_t, 2> stack_sizes{0, 0};  ///< numbers
    };
    std::vector<Run> subtrees;  ///< none depends on another
    Run top;                    ///< what is left, after them
    std::vector<int> depth;     ///< per front

    EliminationSchedule(const FrontTree& fronts, int block_size);
};

}  // namespace sherd
