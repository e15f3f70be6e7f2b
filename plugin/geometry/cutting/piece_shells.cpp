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

// The triangles of the body with a corner on a crack, and one side of every crack face.
std::vector<int> selectTriangles(const LabelBoundary& boundary, const std::vector<char>& on_crack) {
    std::vector<int> selected;
    for (int t = 0; t < boundary.body_count; ++t) {
        const auto& [a, b, c] = boundary.triangles[t];
        if (on_crack[a] || on_crack[b] || on_crack[c]) selected.push_back(t);
    }
    for (int t = boundary.body_count; t < static_cast<int>(boundary.triangles.size()); t += 2)
        selected.push_back(t);
    return selected;
}

// A triangle that runs along an edge.
struct EdgeSide {
    int triangle, label;
    bool from_lower;  // it runs from the edge's lower vertex to the higher one
};

// All of them, with both sides of crack faces.
void collectSides(const LabelBoundary& boundary, const std::vector<int>& selected, const EdgeTable& edges,
                  int edge, std::vector<EdgeSide>& sides) {
    sides.clear();
    for (int u = edges.first_use[edge]; u < edges.first_use[edge + 1]; ++u) {
        const int t = selected[edges.uses[u] / 3];
        const bool from_lower = boundary.triangles[t][edges.uses[u] % 3] == edges.edges[edge][0];
        sides.push_back({t, boundary.labels[t], from_lower});
        const int opposite = boundary.opposite(t);
        if (opposite >= 0) sides.push_back({opposite, boundary.labels[opposite], !from_lower});
    }
}

// Unites the two triangles of each label; false if a label has not two that run in opposite directions.
bool uniteSides(const std::vector<EdgeSide>& sides, UnionFind& sets) {
    for (const EdgeSide& own : sides) {
        int partners = 0;
        for (const EdgeSide& other : sides) {
            if (&other == &own || other.label != own.label) continue;
            if (other.from_lower == own.from_lower) return false;
            sets.unite(own.triangle, other.triangle);
            ++partners;
        }
        if (partners != 1) return false;
    }
    return true;
}

// Unites the triangles of each piece's closed surfaces. At every edge with an end on a crack each label must
// have two triangles, which run along it in opposite directions; false if not. All other edges are the
// body's, which is closed.
bool connectShells(const LabelBoundary& boundary, const CutFaces& faces, UnionFind& sets) {
    std::vector<int> first_of_set(faces.body_set_count, -1);
    for (int t = 0; t < boundary.body_count; ++t) {
        int& first = first_of_set[faces.body_set[t]];
        if (first < 0) first = t;
        sets.unite(first, t);
    }
    const std::vector<char> on_crack = findCrackPoints(boundary, faces.points.size());
    const std::vector<int> selected = selectTriangles(boundary, on_crack);
    std::vector<Triangle> triangles;
    triangles.reserve(selected.size());
    for (int t : selected) triangles.push_back(boundary.triangles[t]);
    const EdgeTable edges = buildEdgeTable(triangles, static_cast<int>(faces.points.size()));
    std::vector<EdgeSide> sides;
    for (std::size_t e = 0; e < edges.edges.size(); ++e) {
        if (!on_crack[edges.edges[e][0]] && !on_crack[edges.edges[e][1]]) continue;
        collectSides(boundary, selected, edges, static_cast<int>(e), sides);
        if (!uniteSides(sides, sets)) return false;
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
        }
        shells[index].triangles.push_back(t);
    }
    for (PieceShell& shell : shells)
        shell.volume = enclosedVolume(points, trianglesOf(shell, boundary), origin);
    return shells;
}

// Makes each cavity part of the smallest shell of its label around it. False if there is none.
bool attachCavities(const LabelBoundary& boundary, const std::vector<Vec3>& points,
                    std::vector<PieceShell>& shells) {
    const auto is_cavity = [](const PieceShell& shell) { return shell.volume < 0; };
    if (std::none_of(shells.begin(), shells.end(), is_cavity)) return true;
    findBoxes(boundary, points, shells);
    for (PieceShell& cavity : shells) {
        if (!is_cavity(cavity)) continue;
        const Vec3& x = points[boundary.triangles[cavity.triangles.front()][0]];
        PieceShell* around = nullptr;
        for (PieceShell& shell : shells)
            if (shell.volume > 0 && shell.label == cavity.label &&
                (!around || shell.volume < around->volume) && contains(shell, x, boundary, points))
                around = &shell;
        if (!around) return false;
        const auto outer_count = static_cast<long>(around->triangles.size());
        around->triangles.insert(around->triangles.end(), cavity.triangles.begin(), cavity.triangles.end());
        std::inplace_merge(around->triangles.begin(), around->triangles.begin() + outer_count,
                           around->triangles.end());
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
    return shell.box.contains(x) && isInside(x, points, trianglesOf(shell, boundary));
}

void findBoxes(const LabelBoundary& boundary, const std::vector<Vec3>& points,
               std::vector<PieceShell>& shells) {
    for (PieceShell& shell : shells) {
        shell.box.setEmpty();
        for (const int t : shell.triangles)
            for (const int v : boundary.triangles[t]) shell.box.extend(points[v]);
    }
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
