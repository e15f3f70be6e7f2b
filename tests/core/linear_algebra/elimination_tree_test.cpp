#include "core/linear_algebra/elimination_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "core/linear_algebra/lattice_matrix.h"
#include "core/linear_algebra/least_fill.h"

namespace sherd {
namespace {

/// Blocks of the factor by playing elimination through: the later neighbours of a vertex become neighbours of
/// each other.
double blocksByElimination(const BlockGraph& graph, const std::vector<int>& order) {
    std::vector<int> place(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<int>(k);
    std::vector<std::set<int>> later(order.size());
    double blocks = 0;
    for (std::size_t k = 0; k < order.size(); ++k)
        for (int e = graph.starts[order[k]]; e < graph.starts[order[k] + 1]; ++e)
            if (place[graph.neighbours[e]] > static_cast<int>(k)) later[k].insert(place[graph.neighbours[e]]);
    for (const std::set<int>& column : later) {
        blocks += 1 + static_cast<double>(column.size());
        if (!column.empty()) later[*column.begin()].insert(std::next(column.begin()), column.end());
    }
    return blocks;
}

TEST(EliminationTree, CountsTheBlocksOfTheFactor) {
    const LatticeMatrix matrix(7, 5, 3);
    const BlockGraph graph = blockGraph(matrix.matrix.starts, matrix.matrix.rows);
    std::vector<int> order(graph.size());
    std::iota(order.begin(), order.end(), 0);
    for (int shuffle = 0; shuffle < 3; ++shuffle) {
        const EliminationTree tree = eliminationTree(graph, order);
        EXPECT_EQ(tree.blocks(), blocksByElimination(graph, order));
        EXPECT_EQ(tree.blocks(), blocksByElimination(graph, tree.order)) << "a postorder makes the same fill";
        for (int k = 0; k + 1 < graph.size(); ++k) EXPECT_GT(tree.parent[k], k);
        std::shuffle(order.begin(), order.end(), std::mt19937(shuffle));
    }
}

TEST(LeastFill, PlacesOnALatticeGiveLessFill) {
    const LatticeMatrix block(11, 11, 11);
    const BlockGraph graph = blockGraph(block.matrix.starts, block.matrix.rows);
    const double by_places = leastFill(graph, block.places).blocks(), without = leastFill(graph, {}).blocks();
    std::vector<int> natural(graph.size());
    std::iota(natural.begin(), natural.end(), 0);
    EXPECT_LT(by_places, 0.9 * without);
    EXPECT_LT(without, eliminationTree(graph, natural).blocks());
}

}  // namespace
}  // namespace sherd
