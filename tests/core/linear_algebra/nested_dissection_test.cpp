#include "core/linear_algebra/nested_dissection.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/linear_algebra/lattice_matrix.h"

namespace sherd {
namespace {

// The last part parts the rest in two that share no edge.
TEST(NestedDissection, TheLastPartSeparatesTheRest) {
    const LatticeMatrix bar(24, 5, 4);
    const BlockGraph graph = blockGraph(bar.matrix.starts, bar.matrix.rows);
    const std::vector<int> part = nestedDissection(graph, bar.places);
    const int last = *std::max_element(part.begin(), part.end());
    ASSERT_GT(last, 1);
    std::vector<int> side(graph.size(), -1), queue;
    int sides = 0;
    for (int first = 0; first < graph.size(); ++first) {
        if (side[first] >= 0 || part[first] == last) continue;
        queue.assign(1, first);
        side[first] = sides;
        for (std::size_t next = 0; next < queue.size(); ++next)
            for (int e = graph.starts[queue[next]]; e < graph.starts[queue[next] + 1]; ++e) {
                const int other = graph.neighbours[e];
                if (side[other] >= 0 || part[other] == last) continue;
                side[other] = sides;
                queue.push_back(other);
            }
        ++sides;
    }
    EXPECT_EQ(sides, 2);
    EXPECT_LE(std::count(part.begin(), part.end(), last), 2 * 5 * 4) << "two layers across the bar";
}

TEST(NestedDissection, AFewVerticesAreOnePart) {
    const LatticeMatrix small(3, 3, 3);
    EXPECT_EQ(nestedDissection(blockGraph(small.matrix.starts, small.matrix.rows), small.places),
              std::vector<int>(27, 0));
    EXPECT_TRUE(nestedDissection(BlockGraph{{0}, {}, {}}, {}).empty());
}

}  // namespace
}  // namespace sherd
