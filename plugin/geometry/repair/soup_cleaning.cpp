#include "geometry/repair/soup_cleaning.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "core/numerics/union_find.h"
#include "geometry/merge_vertices.h"
#include "geometry/repair/cgal_mesh.h"

namespace sherd {
namespace {

using Corners = std::array<int, 3>;
using Edge = std::pair<int, int>;

Corners sorted(Corners t) {
    std::sort(t.begin(), t.end());
    return t;
}

Edge edgeOf(const Corners& t, int k) {
    return std::minmax(t[k], t[(k + 1) % 3]);
}

std::map<Edge, int> trianglesAtEdges(const std::vector<Corners>& triangles) {
    std::map<Edge, int> count;
    for (const Corners& t : triangles)
        for (int k = 0; k < 3; ++k) ++count[edgeOf(t, k)];
    return count;
}

std::vector<int> borderVertices(const TriangleMesh& mesh) {
    std::vector<int> border;
    for (const auto& [edge, count] : trianglesAtEdges(mesh.triangles))
        if (count == 1) border.insert(border.end(), {edge.first, edge.second});
    std::sort(border.begin(), border.end());
    border.erase(std::unique(border.begin(), border.end()), border.end());
    return border;
}

/// Those of some vertices that lie within `tolerance` of each other move to one position.
int weld(TriangleMesh& mesh, std::vector<int> vertices, double tolerance) {
    std::stable_sort(vertices.begin(), vertices.end(),
                     [&](int a, int b) { return mesh.vertices[a].x() < mesh.vertices[b].x(); });
    int welded = 0;
    std::vector<char> moved(mesh.vertices.size(), 0);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vec3& kept = mesh.vertices[vertices[i]];
        if (moved[vertices[i]]) continue;
        for (std::size_t j = i + 1; j < vertices.size(); ++j) {
            Vec3& other = mesh.vertices[vertices[j]];
            if (other.x() - kept.x() > tolerance) break;
            if (moved[vertices[j]] || other == kept || (other - kept).norm() > tolerance) continue;
            other = kept;
            moved[vertices[j]] = 1;
            ++welded;
        }
    }
    return welded;
}

TriangleMesh bare(const TriangleMesh& mesh) {
    TriangleMesh result;
    result.vertices = mesh.vertices;
    result.triangles = mesh.triangles;
    return result;
}

/// Groups of triangles with the same three corners; one representative each.
struct TriangleClasses {
    std::map<Corners, std::vector<int>> members;
    explicit TriangleClasses(const std::vector<Corners>& triangles) {
        for (std::size_t t = 0; t < triangles.size(); ++t)
            members[sorted(triangles[t])].push_back(static_cast<int>(t));
    }
};

bool turnsAlike(const Corners& a, const Corners& b) {
    const auto at = std::find(b.begin(), b.end(), a[0]) - b.begin();
    return a[1] == b[(at + 1) % 3];
}

/// One of each way that a class of triangles faces.
std::vector<int> distinct(const std::vector<Corners>& triangles, const std::vector<int>& members) {
    std::vector<int> kept = {members[0]};
    for (const int t : members)
        if (kept.size() == 1 && !turnsAlike(triangles[kept[0]], triangles[t])) kept.push_back(t);
    return kept;
}

/// Of the classes that face both ways, those that belong to a wall inside.
std::vector<char> wallsInside(const std::vector<Corners>& classes, const std::vector<char>& both_ways) {
    std::map<Edge, std::vector<int>> at_edge;
    for (std::size_t c = 0; c < classes.size(); ++c)
        for (int k = 0; k < 3; ++k) at_edge[edgeOf(classes[c], k)].push_back(static_cast<int>(c));
    UnionFind patches(static_cast<int>(classes.size()));
    for (const auto& [edge, around] : at_edge)
        if (around.size() == 2 && both_ways[around[0]] && both_ways[around[1]])
            patches.unite(around[0], around[1]);
    std::vector<char> ends_free(classes.size(), 0), has_rim(classes.size(), 0), inside(classes.size(), 0);
    for (const auto& [edge, around] : at_edge) {
        const auto single = std::count_if(around.begin(), around.end(), [&](int c) { return !both_ways[c]; });
        for (const int c : around) {
            if (single >= 2) has_rim[patches.root(c)] = 1;
            if (single < 2 && around.size() != 2) ends_free[patches.root(c)] = 1;
        }
    }
    for (std::size_t c = 0; c < classes.size(); ++c) {
        const int patch = patches.root(static_cast<int>(c));
        inside[c] = both_ways[c] && has_rim[patch] && !ends_free[patch];
    }
    return inside;
}

}  // namespace

TriangleMesh stitched(const TriangleMesh& mesh, double tolerance, bool all, RepairReport& report) {
    TriangleMesh merged = mergeEqualVertices(bare(mesh));
    const int lost = static_cast<int>(mesh.vertices.size() - merged.vertices.size());
    report.merged_vertices += lost;
    std::vector<int> near(merged.vertices.size());
    std::iota(near.begin(), near.end(), 0);
    const int welded = weld(merged, all ? near : borderVertices(merged), tolerance);
    report.merged_vertices += welded;
    return welded > 0 ? mergeEqualVertices(merged) : merged;
}

void dropDoubled(TriangleMesh& mesh, RepairReport& report) {
    const TriangleClasses found(mesh.triangles);
    std::vector<Corners> classes;
    std::vector<std::vector<int>> kept;
    std::vector<char> both_ways;
    for (const auto& [corners, members] : found.members) {
        classes.push_back(corners);
        kept.push_back(distinct(mesh.triangles, members));
        both_ways.push_back(kept.back().size() > 1);
    }
    const std::vector<char> inside = wallsInside(classes, both_ways);
    std::vector<char> stays(mesh.triangles.size(), 0);
    for (std::size_t c = 0; c < classes.size(); ++c)
        if (!inside[c]) stays[kept[c][0]] = 1;
    std::vector<Corners> triangles;
    for (std::size_t t = 0; t < stays.size(); ++t)
        if (stays[t]) triangles.push_back(mesh.triangles[t]);
    report.doubled_triangles += static_cast<int>(mesh.triangles.size() - triangles.size());
    mesh.triangles = std::move(triangles);
}

void orientAlike(TriangleMesh& mesh, RepairReport& report) {
    std::map<Edge, int> balance;  // of an edge's two directions
    bool alike = true;
    for (const Corners& t : mesh.triangles)
        for (int k = 0; k < 3; ++k) balance[edgeOf(t, k)] += t[k] < t[(k + 1) % 3] ? 1 : -1;
    for (const auto& [edge, sum] : balance) alike = alike && std::abs(sum) < 2;
    if (alike) return;
    std::vector<RepairKernel::Point_3> points;
    std::vector<std::vector<std::size_t>> polygons;
    for (const Vec3& v : mesh.vertices) points.emplace_back(v.x(), v.y(), v.z());
    for (const auto& [a, b, c] : mesh.triangles)
        polygons.push_back({std::size_t(a), std::size_t(b), std::size_t(c)});
    CGAL::Polygon_mesh_processing::orient_polygon_soup(points, polygons);
    // Points that it doubles where neighbours cannot agree become one again; `partTouching` looks at those.
    for (std::size_t v = mesh.vertices.size(); v < points.size(); ++v)
        mesh.vertices.emplace_back(points[v].x(), points[v].y(), points[v].z());
    for (std::size_t t = 0; t < polygons.size(); ++t) {
        const Corners turned = {int(polygons[t][0]), int(polygons[t][1]), int(polygons[t][2])};
        const auto at = [&](const Corners& corners, int k) { return mesh.vertices[corners[k]]; };
        const Corners before = mesh.triangles[t];
        int k = 0;
        while (k < 2 && at(turned, k) != at(before, 0)) ++k;
        report.turned_triangles += at(turned, (k + 1) % 3) != at(before, 1);
        mesh.triangles[t] = turned;
    }
    mesh = mergeEqualVertices(mesh);
}

}  // namespace sherd
