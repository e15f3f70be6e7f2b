#include "core/linear_algebra/least_fill.h"

#include <amd.h>
#include <camd.h>

#include <array>
#include <numeric>

#include "core/linear_algebra/nested_dissection.h"
#include "core/numerics/parallel_chunks.h"

namespace sherd {
namespace {

// Both return an empty order where memory runs out.

std::vector<int> minimumDegree(const BlockGraph& graph) {
    std::vector<int> order(graph.size());
    std::iota(order.begin(), order.end(), 0);
    if (graph.neighbours.empty()) return order;  // AMD takes no list without entries
    if (amd_order(graph.size(), graph.starts.data(), graph.neighbours.data(), order.data(), nullptr,
                  nullptr) != AMD_OK)
        return {};
    return order;
}

std::vector<int> minimumDegreeInParts(const BlockGraph& graph, const std::vector<int>& parts) {
    if (graph.neighbours.empty()) return minimumDegree(graph);
    std::vector<int> order(graph.size());
    if (camd_order(graph.size(), graph.starts.data(), graph.neighbours.data(), order.data(), nullptr, nullptr,
                   parts.data()) != CAMD_OK)
        return {};
    return order;
}

}  // namespace

EliminationTree leastFill(const BlockGraph& graph, const std::vector<Eigen::Vector3i>& places) {
    std::array<EliminationTree, 2> trees;
    forEachChunk(places.empty() ? 1 : 2, [&](int candidate) {
        const std::vector<int> order = candidate == 0
                                           ? minimumDegree(graph)
                                           : minimumDegreeInParts(graph, nestedDissection(graph, places));
        if (static_cast<int>(order.size()) == graph.size()) trees[candidate] = eliminationTree(graph, order);
    });
    const bool second =
        trees[0].order.empty() || (!trees[1].order.empty() && trees[1].blocks() < trees[0].blocks());
    return std::move(trees[second ? 1 : 0]);
}

}  // namespace sherd
