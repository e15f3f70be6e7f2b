#include "geometry/cutting/edge_table.h"

#include <algorithm>
#include <cstdint>

namespace sherd {

namespace {

// A half-edge by its higher vertex and its number, as one number to be sorted by.
using HalfEdge = std::uint64_t;

HalfEdge halfEdge(int other, int id) {
    return static_cast<std::uint64_t>(other) << 32 | static_cast<std::uint32_t>(id);
}
int otherOf(HalfEdge h) {
    return static_cast<int>(h >> 32);
}
int idOf(HalfEdge h) {
    return static_cast<int>(h & 0xffffffffU);
}

// Half-edges grouped by their lower vertex. By counting, since sorting them all would take most of the time
// on large meshes.
std::vector<HalfEdge> groupByLowerVertex(const std::vector<Triangle>& triangles, std::vector<int>& offset) {
    for (const Triangle& t : triangles)
        for (int i = 0; i < 3; ++i) ++offset[std::min(t[i], t[i < 2 ? i + 1 : 0]) + 1];
    for (std::size_t v = 1; v < offset.size(); ++v) offset[v] += offset[v - 1];
    std::vector<HalfEdge> grouped(3 * triangles.size());
    std::vector<int> next(offset.begin(), offset.end() - 1);
    int id = 0;
    for (const Triangle& t : triangles)
        for (int i = 0; i < 3; ++i, ++id) {
            const int a = t[i], b = t[i < 2 ? i + 1 : 0];
            grouped[next[std::min(a, b)]++] = halfEdge(std::max(a, b), id);
        }
    return grouped;
}

// Insertion sort: most vertices have about six half-edges.
void sortFew(HalfEdge* begin, HalfEdge* end) {
    constexpr long few = 32;
    if (end - begin > few) return std::sort(begin, end);
    for (HalfEdge* place = begin; place < end; ++place) {
        const HalfEdge moved = *place;
        HalfEdge* to = place;
        for (; to > begin && *(to - 1) > moved; --to) *to = *(to - 1);
        *to = moved;
    }
}

}  // namespace

EdgeTable buildEdgeTable(const std::vector<Triangle>& triangles, int vertex_count) {
    std::vector<int> offset(vertex_count + 1, 0);
    std::vector<HalfEdge> grouped = groupByLowerVertex(triangles, offset);
    EdgeTable table;
    table.edges.reserve(grouped.size() / 2);
    table.first_use.reserve(grouped.size() / 2 + 1);
    table.of_triangle.resize(triangles.size());
    table.uses.resize(grouped.size());
    for (int v = 0; v < vertex_count; ++v) {
        sortFew(grouped.data() + offset[v], grouped.data() + offset[v + 1]);
        for (int k = offset[v]; k < offset[v + 1]; ++k) {
            const int other = otherOf(grouped[k]), id = idOf(grouped[k]);
            if (k == offset[v] || other != otherOf(grouped[k - 1])) {
                table.edges.push_back({v, other});
                table.first_use.push_back(k);
            }
            table.of_triangle[id / 3][id % 3] = static_cast<int>(table.edges.size()) - 1;
            table.uses[k] = id;
        }
    }
    table.first_use.push_back(static_cast<int>(grouped.size()));
    return table;
}

}  // namespace sherd
