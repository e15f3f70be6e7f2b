#include "geometry/cutting/spread_colours.h"

#include <algorithm>
#include <map>

namespace sherd {

namespace {

// The edges of crack faces that end in a vertex without a colour, that vertex first; both directions if both
// do.
std::vector<std::array<int, 2>> edgesToUnknown(const std::vector<FragmentSurface>& pieces,
                                               const SharedVertices& shared,
                                               const std::vector<Vec3>& colours) {
    std::vector<std::array<int, 2>> edges;
    for (std::size_t p = 0; p < pieces.size(); ++p)
        for (std::size_t t = 0; t < pieces[p].parents.size(); ++t) {
            if (pieces[p].parents[t] >= 0) continue;
            for (int i = 0; i < 3; ++i)
                for (int k = 1; k < 3; ++k) {
                    const int a = shared.of_piece[p][pieces[p].mesh.triangles[t][i]];
                    const int b = shared.of_piece[p][pieces[p].mesh.triangles[t][(i + k) % 3]];
                    if (colours[a] == unknown_colour) edges.push_back({a, b});
                }
        }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

}  // namespace

SharedVertices shareVertices(const std::vector<FragmentSurface>& pieces) {
    SharedVertices shared;
    std::map<std::array<double, 3>, int> number_of;
    for (const FragmentSurface& piece : pieces) {
        shared.of_piece.emplace_back();
        for (const Vec3& v : piece.mesh.vertices)
            shared.of_piece.back().push_back(
                number_of.try_emplace({v.x(), v.y(), v.z()}, static_cast<int>(number_of.size()))
                    .first->second);
    }
    shared.count = static_cast<int>(number_of.size());
    return shared;
}

void spreadColours(const std::vector<FragmentSurface>& pieces, const SharedVertices& shared,
                   const Vec3& otherwise, std::vector<Vec3>& colours) {
    std::vector<std::array<int, 2>> edges = edgesToUnknown(pieces, shared, colours);
    for (bool reached = true; reached;) {
        std::map<int, std::pair<Vec3, int>> ring;  // sum and count of the known neighbours
        for (const auto& [vertex, other] : edges) {
            if (colours[other] == unknown_colour) continue;
            auto& [sum, count] = ring.try_emplace(vertex, Vec3::Zero(), 0).first->second;
            sum += colours[other];
            ++count;
        }
        for (const auto& [vertex, share] : ring) colours[vertex] = share.first / share.second;
        const auto is_done = [&](const std::array<int, 2>& edge) {
            return colours[edge[0]] != unknown_colour;
        };
        edges.erase(std::remove_if(edges.begin(), edges.end(), is_done), edges.end());
        reached = !ring.empty();
    }
    std::replace(colours.begin(), colours.end(), unknown_colour, otherwise);
}

}  // namespace sherd
