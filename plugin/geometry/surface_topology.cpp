#include "geometry/surface_topology.h"

#include <algorithm>
#include <sstream>
#include <tuple>

#include "core/numerics/union_find.h"

namespace sherd {
namespace {

/// One side of a triangle; `forward` when it runs from the lower to the higher vertex number.
struct EdgeUse {
    int low, high, triangle;
    bool forward;
    bool sameEdge(const EdgeUse& other) const { return low == other.low && high == other.high; }
    bool operator<(const EdgeUse& other) const {
        return std::tie(low, high, triangle) < std::tie(other.low, other.high, other.triangle);
    }
};

std::vector<EdgeUse> sortedEdgeUses(const TriangleMesh& mesh) {
    std::vector<EdgeUse> uses;
    uses.reserve(3 * mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const int from = mesh.triangles[t][k], to = mesh.triangles[t][(k + 1) % 3];
            uses.push_back({std::min(from, to), std::max(from, to), static_cast<int>(t), from < to});
        }
    std::sort(uses.begin(), uses.end());
    return uses;
}

std::string describeEdge(const TriangleMesh& mesh, const EdgeUse& use) {
    return "the edge from " + describePlace(mesh.vertices[use.low]) + " to " +
           describePlace(mesh.vertices[use.high]);
}

Error openEdge(const TriangleMesh& mesh, const EdgeUse& use, std::size_t count) {
    return {"The surface is open: " + describeEdge(mesh, use) + " belongs to triangle " +
            std::to_string(use.triangle) + " only (" + std::to_string(count) +
            " such edges); close the hole, or give the sheet a thickness."};
}

Error crowdedEdge(const TriangleMesh& mesh, const EdgeUse& use, std::size_t count) {
    return {"The surface is not a manifold: " + describeEdge(mesh, use) + " belongs to " +
            std::to_string(count) + " triangles, triangle " + std::to_string(use.triangle) +
            " the first; remove inner walls and doubled faces, or move parts that touch in an edge apart."};
}

Error twistedEdge(const TriangleMesh& mesh, const EdgeUse& use, const EdgeUse& other) {
    return {
        "The surface is not oriented: triangles " + std::to_string(use.triangle) + " and " +
        std::to_string(other.triangle) + " run along " + describeEdge(mesh, use) +
        " in the same direction; make the faces' winding consistent, counter-clockwise seen from outside."};
}

/// Number of a corner among all corners of all triangles.
int cornerOf(const TriangleMesh& mesh, int triangle, int vertex) {
    int k = 0;
    while (mesh.triangles[triangle][k] != vertex) ++k;
    return 3 * triangle + k;
}

/// Corners that meet across edges around a vertex are one fan; a second fan at the same vertex is a pinch.
Status checkFans(const TriangleMesh& mesh, const std::vector<SharedEdge>& edges) {
    UnionFind fans(3 * mesh.triangles.size());
    for (const SharedEdge& edge : edges)
        for (const int vertex : edge.vertices)
            fans.unite(cornerOf(mesh, edge.triangles[0], vertex), cornerOf(mesh, edge.triangles[1], vertex));
    std::vector<int> fan_of_vertex(mesh.vertices.size(), -1);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const int vertex = mesh.triangles[t][k];
            const int fan = fans.root(static_cast<int>(3 * t) + k);
            if (fan_of_vertex[vertex] == -1) fan_of_vertex[vertex] = fan;
            if (fan_of_vertex[vertex] != fan)
                return Error{"The surface is not a manifold: it touches itself in the single point " +
                             describePlace(mesh.vertices[vertex]) + ", a corner of triangle " +
                             std::to_string(t) + "; join the parts there, or move them apart."};
        }
    return success();
}

}  // namespace

std::string describePlace(const Vec3& position) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(4);
    text << '(' << position.x() << ", " << position.y() << ", " << position.z() << ')';
    return text.str();
}

Result<std::vector<SharedEdge>> closedManifoldEdges(const TriangleMesh& mesh) {
    const std::vector<EdgeUse> uses = sortedEdgeUses(mesh);
    std::vector<SharedEdge> edges;
    edges.reserve(uses.size() / 2);
    const EdgeUse *open = nullptr, *twisted = nullptr;
    std::size_t open_count = 0;
    for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
        const EdgeUse& use = uses[begin];
        while (end < uses.size() && uses[end].sameEdge(use)) ++end;
        const EdgeUse& last = uses[end - 1];
        if (end - begin > 2) return crowdedEdge(mesh, use, end - begin);
        if (end - begin == 1) {
            open = open ? open : &use;
            ++open_count;
        } else if (use.forward == last.forward) {
            twisted = twisted ? twisted : &use;
        } else {
            const EdgeUse &forward = use.forward ? use : last, &backward = use.forward ? last : use;
            edges.push_back({{use.low, use.high}, {forward.triangle, backward.triangle}});
        }
    }
    if (open) return openEdge(mesh, *open, open_count);
    if (twisted) return twistedEdge(mesh, *twisted, *(twisted + 1));
    if (Status fans = checkFans(mesh, edges); !fans) return Error{fans.error()};
    return edges;
}

std::vector<int> shellOfTriangle(const TriangleMesh& mesh, const std::vector<SharedEdge>& edges) {
    UnionFind shells(mesh.triangles.size());
    for (const SharedEdge& edge : edges) shells.unite(edge.triangles[0], edge.triangles[1]);
    std::vector<int> number_of_set(mesh.triangles.size(), -1), shell(mesh.triangles.size());
    int count = 0;
    for (std::size_t t = 0; t < shell.size(); ++t) {
        int& number = number_of_set[shells.root(static_cast<int>(t))];
        if (number == -1) number = count++;
        shell[t] = number;
    }
    return shell;
}

}  // namespace sherd
