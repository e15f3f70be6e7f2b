#include "geometry/cutting/edge_table.h"

#include <algorithm>
#include <tuple>

namespace sherd {

namespace {

struct HalfEdge {
    int other;  // the higher vertex
    int id;
};

// Half-edges grouped by their lower vertex: a counting sort, since a comparison sort would dominate on large
// meshes.
std::vector<HalfEdge> groupByLowerVertex(const std::vector<Triangle>& triangles, std::vector<int>& offset) {
    for (const Triangle& t : triangles)
        for (int i = 0; i < 3; ++i) ++offset[std::min(t[i], t[(i + 1) % 3]) + 1];
    for (std::size_t v = 1; v < offset.size(); ++v) offset[v] += offset[v - 1];
    std::vector<HalfEdge> grouped(3 * triangles.size());
    std::vector<int> next(offset.begin(), offset.end() - 1);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (int i = 0; i < 3; ++i) {
            const auto [low, high] = std::minmax(triangles[t][i], triangles[t][(i + 1) % 3]);
            grouped[next[low]++] = {high, static_cast<int>(3 * t) + i};
        }
    return grouped;
}

}  // namespace

int EdgeTable::find(int a, int b) const {
    const auto [low, high] = std::minmax(a, b);
    const auto begin = edges.begin() + first_edge[low], end = edges.begin() + first_edge[low + 1];
    const auto found = std::lower_bound(begin, end, std::array<int, 2>{low, high});
    return found != end && (*found)[1] == high ? static_cast<int>(found - edges.begin()) : -1;
}

EdgeTable buildEdgeTable(const std::vector<Triangle>& triangles, int vertex_count) {
    std::vector<int> offset(vertex_count + 1, 0);
    std::vector<HalfEdge> grouped = groupByLowerVertex(triangles, offset);
    EdgeTable table;
    table.edges.reserve(grouped.size() / 2);
    table.of_triangle.resize(triangles.size());
    table.uses.reserve(grouped.size());
    table.first_edge.resize(vertex_count + 1);
    for (int v = 0; v < vertex_count; ++v) {
        table.first_edge[v] = static_cast<int>(table.edges.size());
        std::sort(grouped.begin() + offset[v], grouped.begin() + offset[v + 1],
                  [](const HalfEdge& a, const HalfEdge& b) {
                      return std::tie(a.other, a.id) < std::tie(b.other, b.id);
                  });
        for (int k = offset[v]; k < offset[v + 1]; ++k) {
            if (k == offset[v] || grouped[k].other != grouped[k - 1].other) {
                table.edges.push_back({v, grouped[k].other});
                table.first_use.push_back(k);
            }
            table.of_triangle[grouped[k].id / 3][grouped[k].id % 3] =
                static_cast<int>(table.edges.size()) - 1;
            table.uses.push_back(grouped[k].id);
        }
    }
    table.first_edge[vertex_count] = static_cast<int>(table.edges.size());
    table.first_use.push_back(static_cast<int>(grouped.size()));
    return table;
}

}  // namespace sherd
