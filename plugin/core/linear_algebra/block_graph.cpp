#include "core/linear_algebra/block_graph.h"

#include <numeric>

namespace sherd {

BlockGraph blockGraph(const std::vector<int>& starts, const std::vector<int>& rows) {
    const int count = static_cast<int>(starts.size()) - 1;
    // visit(column, row, position) for every block below the diagonal, by columns.
    const auto forEachBlock = [&](const auto& visit) {
        for (int column = 0; column < count; ++column)
            for (int k = starts[column]; k < starts[column + 1]; ++k)
                if (rows[k] > column) visit(column, rows[k], k - starts[column]);
    };
    BlockGraph graph;
    graph.starts.assign(count + 1, 0);
    forEachBlock([&](int column, int row, int) {
        ++graph.starts[column + 1];
        ++graph.starts[row + 1];
    });
    std::partial_sum(graph.starts.begin(), graph.starts.end(), graph.starts.begin());
    graph.neighbours.resize(graph.starts.back());
    graph.positions.resize(graph.starts.back());
    std::vector<int> next(graph.starts.begin(), graph.starts.end() - 1);
    const auto add = [&](int vertex, int neighbour, int position) {
        const int edge = next[vertex]++;
        graph.neighbours[edge] = neighbour;
        graph.positions[edge] = position;
    };
    // First the lower neighbours of all vertices, then the higher ones, so that lists ascend.
    forEachBlock([&](int column, int row, int position) { add(row, column, position); });
    forEachBlock([&](int column, int row, int position) { add(column, row, position); });
    return graph;
}

}  // namespace sherd
