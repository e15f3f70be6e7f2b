#include "geometry/surface_topology.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <tuple>
#include <utility>

#include "core/numerics/union_find.h"
#include "geometry/sentences.h"

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
            if (from == to) continue;  // of a triangle without area, which has its own sentence
            uses.push_back({std::min(from, to), std::max(from, to), static_cast<int>(t), from < to});
        }
    std::sort(uses.begin(), uses.end());
    return uses;
}

std::string describeEdge(const TriangleMesh& mesh, const EdgeUse& use) {
    return "the edge from " + describePlace(mesh.vertices[use.low]) + " to " +
           describePlace(mesh.vertices[use.high]);
}

/// Faults of one kind: the first, which is described, and the triangles of all.
struct EdgeFaults {
    const EdgeUse *first = nullptr, *partner = nullptr;
    std::size_t first_count = 0;  // triangles at the first edge
    std::vector<int> triangles;   // one for each edge

    void add(const EdgeUse& use, const EdgeUse& other, std::size_t count) {
        if (!first) first = &use, partner = &other, first_count = count;
        triangles.push_back(use.triangle);
    }
    /// " (4 such edges, at triangles 3, 5, 6 and 9)"; nothing for a single one.
    std::string others(const TriangleMesh& mesh) const {
        if (triangles.size() < 2) return "";
        return " (" + std::to_string(triangles.size()) + " such edges, at " +
               describeTriangles(mesh, triangles) + ")";
    }
};

std::string openEdges(const TriangleMesh& mesh, const EdgeFaults& open) {
    return "The surface is open: " + describeEdge(mesh, *open.first) + " belongs to " +
           describeTriangle(mesh, open.first->triangle) + " only" + open.others(mesh) +
           "; close the hole, or give the sheet a thickness (a vessel: Repair::shell_thickness_m).";
}

std::string crowdedEdges(const TriangleMesh& mesh, const EdgeFaults& crowded) {
    return "The surface is not a manifold: " + describeEdge(mesh, *crowded.first) + " belongs to " +
           std::to_string(crowded.first_count) + " triangles, " +
           describeTriangle(mesh, crowded.first->triangle) + " the first" + crowded.others(mesh) +
           "; remove inner walls and doubled faces, or move parts that touch in an edge apart.";
}

std::string twistedEdges(const TriangleMesh& mesh, const EdgeFaults& twisted) {
    return "The surface is not oriented: " +
           describeTriangles(mesh, {twisted.first->triangle, twisted.partner->triangle}) + " run along " +
           describeEdge(mesh, *twisted.first) + " in the same direction" + twisted.others(mesh) +
           "; make the faces' winding consistent, counter-clockwise seen from outside.";
}

/// Number of a corner among all corners of all triangles.
int cornerOf(const TriangleMesh& mesh, int triangle, int vertex) {
    int k = 0;
    while (mesh.triangles[triangle][k] != vertex) ++k;
    return 3 * triangle + k;
}

/// Corners that meet across edges around a vertex are one fan; a second fan at the same vertex is a pinch.
/// Where the surface is open, or crowded edges part it, fans end there; only vertices away from those are
/// looked at.
std::string pinches(const TriangleMesh& mesh, const std::vector<SharedEdge>& edges,
                    const std::vector<char>& skipped) {
    UnionFind fans(3 * mesh.triangles.size());
    for (const SharedEdge& edge : edges)
        for (const int vertex : edge.vertices)
            fans.unite(cornerOf(mesh, edge.triangles[0], vertex), cornerOf(mesh, edge.triangles[1], vertex));
    std::vector<int> fan_of_vertex(mesh.vertices.size(), -1);
    std::vector<char> pinched(mesh.vertices.size(), 0);
    std::vector<int> triangles;
    int first = -1;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const int vertex = mesh.triangles[t][k];
            const int fan = fans.root(static_cast<int>(3 * t) + k);
            if (fan_of_vertex[vertex] == -1) fan_of_vertex[vertex] = fan;
            if (fan_of_vertex[vertex] == fan || skipped[vertex] || pinched[vertex]) continue;
            pinched[vertex] = 1;
            if (triangles.empty()) first = vertex;
            triangles.push_back(static_cast<int>(t));
        }
    if (triangles.empty()) return "";
    const std::string others = triangles.size() < 2
                                   ? ""
                                   : " (" + std::to_string(triangles.size()) + " such points, at " +
                                         describeTriangles(mesh, triangles) + ")";
    return "The surface is not a manifold: it touches itself in the single point " +
           describePlace(mesh.vertices[first]) + ", a corner of " + describeTriangle(mesh, triangles[0]) +
           others + "; join the parts there, or move them apart.";
}

}  // namespace

std::string describePlace(const Vec3& position) {
    constexpr double rounding_m = 1e-9;
    const auto rounded = [](double x) { return std::abs(x) < rounding_m ? 0 : x; };
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(4);
    text << '(' << rounded(position.x()) << ", " << rounded(position.y()) << ", " << rounded(position.z())
         << ')';
    return text.str();
}

std::string describeTriangle(const TriangleMesh& mesh, int triangle) {
    if (mesh.file_faces.empty()) return "triangle " + std::to_string(triangle);
    return "face " + std::to_string(mesh.file_faces[triangle]);
}

std::string describeTriangles(const TriangleMesh& mesh, const std::vector<int>& triangles) {
    if (triangles.size() == 1) return describeTriangle(mesh, triangles[0]);
    if (mesh.file_faces.empty()) return "triangles " + firstOf(triangles);
    std::vector<int> faces;
    for (const int t : triangles)
        if (faces.empty() || faces.back() != mesh.file_faces[t]) faces.push_back(mesh.file_faces[t]);
    return (faces.size() == 1 ? "face " : "faces ") + firstOf(faces);
}

SurfaceTopology surfaceTopology(const TriangleMesh& mesh) {
    const std::vector<EdgeUse> uses = sortedEdgeUses(mesh);
    SurfaceTopology topology;
    topology.edges.reserve(uses.size() / 2);
    EdgeFaults open, crowded, twisted;
    std::vector<char> on_fault(mesh.vertices.size(), 0);
    for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
        const EdgeUse& use = uses[begin];
        while (end < uses.size() && uses[end].sameEdge(use)) ++end;
        const EdgeUse& last = uses[end - 1];
        const std::size_t count = end - begin;
        if (count == 2 && use.forward != last.forward) {
            const EdgeUse &forward = use.forward ? use : last, &backward = use.forward ? last : use;
            topology.edges.push_back({{use.low, use.high}, {forward.triangle, backward.triangle}});
            continue;
        }
        on_fault[use.low] = on_fault[use.high] = 1;
        (count == 1 ? open : count == 2 ? twisted : crowded).add(use, last, count);
    }
    if (crowded.first) topology.faults.push_back(crowdedEdges(mesh, crowded));
    if (open.first) topology.faults.push_back(openEdges(mesh, open));
    if (twisted.first) topology.faults.push_back(twistedEdges(mesh, twisted));
    const std::string pinched = pinches(mesh, topology.edges, on_fault);
    if (!pinched.empty()) topology.faults.push_back(pinched);
    topology.manifold = !crowded.first && !twisted.first && pinched.empty();
    return topology;
}

Result<std::vector<SharedEdge>> closedManifoldEdges(const TriangleMesh& mesh) {
    SurfaceTopology topology = surfaceTopology(mesh);
    if (!topology.faults.empty()) return Error{topology.faults.front()};
    return std::move(topology.edges);
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
