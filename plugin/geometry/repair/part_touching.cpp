#include "geometry/repair/part_touching.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "core/numerics/union_find.h"

namespace sherd {
namespace {

constexpr double pull = 1e-3;  // of the shortest edge around: parts that touched are apart by twice that

/// A side of a triangle: corner `corner` of `triangle` and the next one.
struct Side {
    int triangle, corner;
    bool forward;      // from the lower to the higher vertex
    double angle = 0;  // around the edge, from an arbitrary start
};

using Edges = std::map<std::pair<int, int>, std::vector<Side>>;

Edges sidesAtEdges(const TriangleMesh& mesh) {
    Edges edges;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const int from = mesh.triangles[t][k], to = mesh.triangles[t][(k + 1) % 3];
            edges[std::minmax(from, to)].push_back({static_cast<int>(t), k, from < to});
        }
    return edges;
}

/// Several triangles, or two that are turned against each other.
bool isCrowded(const std::vector<Side>& sides) {
    return sides.size() > 2 || (sides.size() == 2 && sides[0].forward == sides[1].forward);
}

using SidePair = std::pair<Side, Side>;

/// Sides in order around their edge, counter-clockwise seen along it.
void sortAround(const TriangleMesh& mesh, int low, int high, std::vector<Side>& sides) {
    const Vec3 axis = (mesh.vertices[high] - mesh.vertices[low]).normalized();
    const Vec3 first = axis.unitOrthogonal(), second = axis.cross(first);
    for (Side& side : sides) {
        const int tip = mesh.triangles[side.triangle][(side.corner + 2) % 3];
        const Vec3 arm = mesh.vertices[tip] - mesh.vertices[low];
        side.angle = std::atan2(arm.dot(second), arm.dot(first));
    }
    std::stable_sort(sides.begin(), sides.end(),
                     [](const Side& a, const Side& b) { return a.angle < b.angle; });
}

/// A triangle that runs forward has its material before it in the angle, one that runs backward after it: a
/// backward one and a forward one that follows bound a wedge.
std::vector<SidePair> wedges(const std::vector<Side>& sides) {
    std::vector<SidePair> pairs;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const Side &side = sides[i], &next = sides[(i + 1) % sides.size()];
        if (!side.forward && next.forward) pairs.push_back({side, next});
    }
    return pairs;
}

class Parting {
  public:
    explicit Parting(TriangleMesh& mesh) : mesh_(mesh) {}

    int run() {
        splitCrowdedEdges();
        fans_.emplace(static_cast<int>(3 * mesh_.triangles.size()));
        joinWedges();
        return drawApart();
    }

  private:
    /// Puts a vertex in the middle of every crowded edge, so that no two edges of
    /// the result have the same ends. Triangles are split one side at a time.
    void splitCrowdedEdges() {
        for (bool any = true; any;) {
            any = false;
            std::vector<char> split(mesh_.triangles.size(), 0);
            for (const auto& [edge, sides] : sidesAtEdges(mesh_)) {
                if (!isCrowded(sides) || middles_.count(edge.first) || middles_.count(edge.second)) continue;
                const bool free = std::none_of(sides.begin(), sides.end(),
                                               [&](const Side& s) { return split[s.triangle] != 0; });
                any = true;
                if (!free) continue;
                splitEdge(edge, sides, split);
            }
        }
    }

    void splitEdge(const std::pair<int, int>& edge, const std::vector<Side>& sides,
                   std::vector<char>& split) {
        const int middle = static_cast<int>(mesh_.vertices.size());
        mesh_.vertices.push_back((mesh_.vertices[edge.first] + mesh_.vertices[edge.second]) / 2);
        middles_.insert(middle);
        for (const Side& side : sides) {
            auto& t = mesh_.triangles[side.triangle];
            auto other = t;
            t[(side.corner + 1) % 3] = middle;
            other[side.corner] = middle;
            split[side.triangle] = 1;
            mesh_.triangles.push_back(other);
        }
    }

    void join(const Side& a, const Side& b) {
        const auto corner = [](const Side& side, int next) {
            return 3 * side.triangle + (side.corner + next) % 3;
        };
        fans_->unite(corner(a, 0), corner(b, 1));
        fans_->unite(corner(a, 1), corner(b, 0));
    }

    void joinWedges() {
        for (auto& [edge, sides] : sidesAtEdges(mesh_)) {
            if (sides.size() == 2 && sides[0].forward != sides[1].forward) join(sides[0], sides[1]);
            if (sides.size() <= 2) continue;
            sortAround(mesh_, edge.first, edge.second, sides);
            for (const SidePair& wedge : wedges(sides)) join(wedge.first, wedge.second);
        }
    }

    /// Gives every fan its vertex; returns at how many vertices there was more than one.
    int drawApart() {
        const std::size_t before = mesh_.vertices.size();
        std::vector<int> fan_of_vertex(before, -1);
        std::map<int, int> vertex_of_fan;
        std::vector<char> parted(before, 0);
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
            for (int k = 0; k < 3; ++k) {
                const int fan = fans_->root(static_cast<int>(3 * t) + k), vertex = mesh_.triangles[t][k];
                if (fan_of_vertex[vertex] < 0) {
                    fan_of_vertex[vertex] = fan;
                    vertex_of_fan[fan] = vertex;
                } else if (!vertex_of_fan.count(fan)) {
                    vertex_of_fan[fan] = static_cast<int>(mesh_.vertices.size());
                    mesh_.vertices.push_back(Vec3(mesh_.vertices[vertex]));
                    parted[vertex] = 1;
                }
            }
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
            for (int k = 0; k < 3; ++k)
                mesh_.triangles[t][k] = vertex_of_fan.at(fans_->root(static_cast<int>(3 * t) + k));
        pullBack(parted, before);
        return static_cast<int>(std::count(parted.begin(), parted.end(), 1));
    }

    void pullBack(const std::vector<char>& parted, std::size_t before) {
        std::vector<Vec3> inward(mesh_.vertices.size(), Vec3::Zero());
        std::vector<double> shortest(mesh_.vertices.size(), INFINITY);
        for (const auto& t : mesh_.triangles)
            for (int k = 0; k < 3; ++k) {
                const Vec3 &a = mesh_.vertices[t[k]], &b = mesh_.vertices[t[(k + 1) % 3]],
                           &c = mesh_.vertices[t[(k + 2) % 3]];
                inward[t[k]] -= (b - a).cross(c - a).stableNormalized();
                shortest[t[k]] = std::min({shortest[t[k]], (b - a).norm(), (c - a).norm()});
            }
        for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) {
            const bool moves = v < before ? parted[v] != 0 : true;
            if (moves && std::isfinite(shortest[v]))
                mesh_.vertices[v] += pull * shortest[v] * inward[v].stableNormalized();
        }
    }

    TriangleMesh& mesh_;
    std::set<int> middles_;  // vertices that were put in; their edges are not split again
    std::optional<UnionFind> fans_;
};

}  // namespace

void partTouching(TriangleMesh& mesh, RepairReport& report) {
    report.parted_places += Parting(mesh).run();
}

}  // namespace sherd
