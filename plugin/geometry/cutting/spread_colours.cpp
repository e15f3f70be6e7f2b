#include "geometry/cutting/spread_colours.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <utility>

#include "core/numerics/split_mix.h"

namespace sherd {

namespace {

/// Numbers of positions, in the order in which they are first asked for.
class PositionNumbers {
  public:
    explicit PositionNumbers(std::size_t most) {
        std::size_t size = 64;
        while (size < 2 * most) size *= 2;
        table_.assign(size, -1);
    }
    int of(const Vec3& x) {
        const std::size_t mask = table_.size() - 1;
        std::size_t place = hash(x) & mask;
        for (; table_[place] >= 0; place = (place + 1) & mask)
            if (positions_[table_[place]] == x) return table_[place];
        positions_.push_back(x);
        return table_[place] = static_cast<int>(positions_.size()) - 1;
    }
    int count() const { return static_cast<int>(positions_.size()); }

  private:
    static std::size_t hash(const Vec3& x) {
        std::uint64_t result = 0;
        for (const double coordinate : x) {
            const double without_sign_of_zero = coordinate + 0.0;
            std::uint64_t bits;
            std::memcpy(&bits, &without_sign_of_zero, sizeof bits);
            result = splitMix64(result ^ bits);
        }
        return static_cast<std::size_t>(result);
    }

    std::vector<int> table_;  // -1: free
    std::vector<Vec3> positions_;
};

/// An edge of a crack face to a vertex without a colour.
struct EdgeToUnknown {
    int vertex, other;
};

// Calls visit(vertex, other) for all of them, both directions if both ends have no colour; often twice.
template <class Visit>
void forEachEdgeToUnknown(const std::vector<FragmentSurface>& pieces, const SharedVertices& shared,
                          const std::vector<Vec3>& colours, const Visit& visit) {
    for (std::size_t p = 0; p < pieces.size(); ++p)
        for (std::size_t t = 0; t < pieces[p].parents.size(); ++t) {
            if (pieces[p].parents[t] >= 0) continue;
            for (int i = 0; i < 3; ++i) {
                const int a = shared.of_piece[p][pieces[p].mesh.triangles[t][i]];
                if (colours[a] != unknown_colour) continue;
                for (int k = 1; k < 3; ++k)
                    visit(a, shared.of_piece[p][pieces[p].mesh.triangles[t][(i + k) % 3]]);
            }
        }
}

// Each once, sorted by vertex, then by the other end.
std::vector<EdgeToUnknown> edgesToUnknown(const std::vector<FragmentSurface>& pieces,
                                          const SharedVertices& shared, const std::vector<Vec3>& colours) {
    std::vector<int> first(shared.count + 1, 0);
    forEachEdgeToUnknown(pieces, shared, colours, [&](int vertex, int) { ++first[vertex + 1]; });
    for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
    std::vector<int> others(first.back()), next(first.begin(), first.end() - 1);
    forEachEdgeToUnknown(pieces, shared, colours,
                         [&](int vertex, int other) { others[next[vertex]++] = other; });
    std::vector<EdgeToUnknown> edges;
    edges.reserve(others.size());
    for (int v = 0; v < shared.count; ++v) {
        const auto begin = others.begin() + first[v], end = others.begin() + first[v + 1];
        std::sort(begin, end);
        for (auto other = begin; other != end; ++other)
            if (other == begin || *other != *(other - 1)) edges.push_back({v, *other});
    }
    return edges;
}

}  // namespace

SharedVertices shareVertices(const std::vector<FragmentSurface>& pieces) {
    std::size_t most = 0;
    for (const FragmentSurface& piece : pieces) most += piece.mesh.vertices.size();
    PositionNumbers numbers(most);
    SharedVertices shared;
    for (const FragmentSurface& piece : pieces) {
        shared.of_piece.emplace_back();
        shared.of_piece.back().reserve(piece.mesh.vertices.size());
        for (const Vec3& v : piece.mesh.vertices) shared.of_piece.back().push_back(numbers.of(v));
    }
    shared.count = numbers.count();
    return shared;
}

void spreadColours(const std::vector<FragmentSurface>& pieces, const SharedVertices& shared,
                   const Vec3& otherwise, std::vector<Vec3>& colours) {
    std::vector<EdgeToUnknown> edges = edgesToUnknown(pieces, shared, colours);
    std::vector<std::pair<int, Vec3>> ring;  // vertices that get a colour
    do {
        ring.clear();
        std::size_t kept = 0;
        for (std::size_t begin = 0, end; begin < edges.size(); begin = end) {
            const int vertex = edges[begin].vertex;
            Vec3 sum = Vec3::Zero();
            int count = 0;
            for (end = begin; end < edges.size() && edges[end].vertex == vertex; ++end) {
                if (colours[edges[end].other] == unknown_colour) continue;
                sum += colours[edges[end].other];
                ++count;
            }
            if (count > 0)
                ring.emplace_back(vertex, sum / count);
            else
                for (std::size_t e = begin; e < end; ++e) edges[kept++] = edges[e];
        }
        edges.resize(kept);
        for (const auto& [vertex, colour] : ring) colours[vertex] = colour;
    } while (!ring.empty());
    std::replace(colours.begin(), colours.end(), unknown_colour, otherwise);
}

}  // namespace sherd
