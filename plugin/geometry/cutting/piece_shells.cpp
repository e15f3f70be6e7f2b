#include "geometry/cutting/piece_shells.h"

#include <algorithm>

#include "core/numerics/mesh_measures.h"
#include "core/numerics/union_find.h"
#include "geometry/cutting/point_location.h"

namespace sherd {

namespace {

std::vector<char> findCrackPoints(const LabelBoundary& boundary, std::size_t point_count) {
    std::vector<char> on_crack(point_count, false);
    for (std::size_t t = boundary.body_count; t < boundary.triangles.size(); ++t)
        for (int v : boundary.triangles[t]) on_crack[v] = true;
    return on_crack;
}

std::vector<int> trianglesAt(const LabelBoundary& boundary, const std::vector<char>& marked) {
    std::vector<int> selected;
    for (std::size_t t = 0; t < boundary.triangles.size(); ++t) {
        const auto& [a, b, c] = boundary.triangles[t];
        if (marked[a] || marked[b] || marked[c]) selected.push_back(static_cast<int>(t));
    }
    return selected;
}

// Unites the triangles of each piece's closed surfaces. At every edge with an end on a crack each label must
// have two triangles, which run along it in opposite directions; false if not. All other edges are the
// body's, which is closed.
bool connectShells(const LabelBoundary& boundary, const CutFaces& faces, UnionFind& sets) {
    for (int t = 0; t < boundary.body_count; ++t) sets.unite(t, faces.body_set[t]);
    const std::vector<char> on_crack = findCrackPoints(boundary, faces.points.size());
    const std::vector<int> selected = trianglesAt(boundary, on_crack);
    std::vector<Triangle> triangles;
    triangles.reserve(selected.size());
    for (int t : selected) triangles.push_back(boundary.triangles[t]);
    const EdgeTable edges = buildEdgeTable(triangles, static_cast<int>(faces.points.size()));
    for (std::size_t e = 0; e < edges.edges.size(); ++e) {
        if (!on_crack[edges.edges[e][0]] && !on_crack[edges.edges[e][1]]) continue;
        const int begin = edges.first_use[e], end = edges.first_use[e + 1];
        for (int u = begin; u < end; ++u) {
            const int t = selected[edges.uses[u] / 3], start = boundary.triangles[t][edges.uses[u] % 3];
            int partners = 0;
            for (int w = begin; w < end; ++w) {
                const int other = selected[edges.uses[w] / 3];
                if (w == u || boundary.labels[other] != boundary.labels[t]) continue;
                if (boundary.triangles[other][edges.uses[w] % 3] == start) return false;
                sets.unite(t, other);
                ++partners;
            }
            if (partners != 1) return false;
        }
    }
    return true;
}

std::vector<Triangle> trianglesOf(const PieceShell& shell, const LabelBoundary& boundary) {
    std::vector<Triangle> triangles;
    triangles.reserve(shell.triangles.size());
    for (int t : shell.triangles) triangles.push_back(boundary.triangles[t]);
    return triangles;
}

// The united sets, in the order of their first triangles. Cavities are shells with a negative volume.
std::vector<PieceShell> collectShells(const LabelBoundary& boundary, const std::vector<Vec3>& points,
                                      const Vec3& origin, UnionFind& sets) {
    std::vector<int> shell_of(boundary.triangles.size(), -1);
    std::vector<PieceShell> shells;
    for (int t = 0; t < static_cast<int>(boundary.triangles.size()); ++t) {
        int& index = shell_of[sets.root(t)];
        if (index < 0) {
            index = static_cast<int>(shells.size());
            shells.emplace_back();
            shells.back().label = boundary.labels[t];
            shells.back().low = shells.back().high = points[boundary.triangles[t][0]];
        }
        PieceShell& shell = shells[index];
        shell.triangles.push_back(t);
        for (int v : boundary.triangles[t]) {
            shell.low = shell.low.cwiseMin(points[v]);
            shell.high = shell.high.cwiseMax(points[v]);
        }
    }
    for (PieceShell& shell : shells)
        shell.volume = enclosedVolume(points, trianglesOf(shell, boundary), origin);
    return shells;
}

// Makes each cavity part of the smallest shell of its label around it. False if there is none.
bool attachCavities(const LabelBoundary& boundary, const std::vector<Vec3>& points,
                    std::vector<PieceShell>& shells) {
    for (PieceShell& cavity : shells) {
        if (cavity.volume >= 0) continue;
        const Vec3& x = points[boundary.triangles[cavity.triangles.front()][0]];
        PieceShell* around = nullptr;
        for (PieceShell& shell : shells)
            if (shell.volume > 0 && shell.label == cavity.label &&
                (!around || shell.volume < around->volume) && contains(shell, x, boundary, points))
                around = &shell;
        if (!around) return false;
        around->triangles.insert(around->triangles.end(), cavity.triangles.begin(), cavity.triangles.end());
        around->volume += cavity.volume;
        cavity.triangles.clear();
    }
    removeEmptyShells(shells);
    return true;
}

}  // namespace

Result<std::vector<PieceShell>> pieceShells(const LabelBoundary& boundary, const CutFaces& faces,
                                            const Vec3& origin) {
    UnionFind sets(boundary.triangles.size());
    if (!connectShells(boundary, faces, sets)) return Error{"a fragment would be open"};
    std::vector<PieceShell> shells = collectShells(boundary, faces.points, origin, sets);
    if (!attachCavities(boundary, faces.points, shells)) return Error{"a cavity has no fragment around it"};
    return shells;
}

bool contains(const PieceShell& shell, const Vec3& x, const LabelBoundary& boundary,
              const std::vector<Vec3>& points) {
    if ((x.array() < shell.low.array()).any() || (x.array() > shell.high.array()).any()) return false;
    return isInside(x, points, trianglesOf(shell, boundary));
}

std::vector<int> pieceOfTriangle(const std::vector<PieceShell>& shells, const LabelBoundary& boundary) {
    std::vector<int> shell_of(boundary.triangles.size(), -1);
    for (std::size_t s = 0; s < shells.size(); ++s)
        for (int t : shells[s].triangles) shell_of[t] = static_cast<int>(s);
    return shell_of;
}

void removeEmptyShells(std::vector<PieceShell>& shells) {
    shells.erase(std::remove_if(shells.begin(), shells.end(),
                                [](const PieceShell& shell) { return shell.triangles.empty(); }),
                 shells.end());
}

}  // namespace sherd
