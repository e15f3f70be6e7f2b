#include "geometry/repair/align_diagonals.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "core/numerics/mesh_measures.h"

namespace sherd {
namespace {

using Corners = std::array<int, 3>;

/// The triangles (p, q, r) and (q, p, s), which make the quadrilateral q, r, p, s.
struct Quadrilateral {
    int first, second;  // triangles
    int p, q, r, s;

    std::array<int, 4> key() const {
        std::array<int, 4> sorted = {p, q, r, s};
        std::sort(sorted.begin(), sorted.end());
        return sorted;
    }
    bool hasDiagonal(int a, int b) const { return std::minmax(p, q) == std::minmax(a, b); }
};

/// Those around every edge that two triangles run along in opposite directions.
std::map<std::array<int, 4>, std::vector<Quadrilateral>> quadrilateralsOf(
    const std::vector<Corners>& triangles) {
    struct Side {
        int triangle, apex;
        bool forward;
    };
    std::map<std::pair<int, int>, std::vector<Side>> at_edge;
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const int from = triangles[t][k], to = triangles[t][(k + 1) % 3];
            at_edge[std::minmax(from, to)].push_back(
                {static_cast<int>(t), triangles[t][(k + 2) % 3], from < to});
        }
    std::map<std::array<int, 4>, std::vector<Quadrilateral>> found;
    for (const auto& [edge, sides] : at_edge) {
        if (sides.size() != 2 || sides[0].forward == sides[1].forward) continue;
        const Side &forward = sides[0].forward ? sides[0] : sides[1],
                   &backward = sides[0].forward ? sides[1] : sides[0];
        const Quadrilateral quad = {forward.triangle, backward.triangle, edge.first,
                                    edge.second,      forward.apex,      backward.apex};
        if (quad.r != quad.s) found[quad.key()].push_back(quad);
    }
    return found;
}

bool isPlane(const TriangleMesh& mesh, const Quadrilateral& quad, double tolerance) {
    const Vec3 &p = mesh.vertices[quad.p], &q = mesh.vertices[quad.q];
    const Vec3 &r = mesh.vertices[quad.r], &s = mesh.vertices[quad.s];
    const Vec3 normal = (q - p).cross(r - p).stableNormalized();
    return std::abs(normal.dot(s - p)) <= tolerance;
}

}  // namespace

void alignDiagonals(TriangleMesh& mesh, double tolerance) {
    std::vector<char> is_new(mesh.triangles.size(),
                             0);  // these are in no quadrilateral that was found before
    for (const auto& [corners, quads] : quadrilateralsOf(mesh.triangles)) {
        const Quadrilateral& kept = quads[0];
        if (is_new[kept.first] || is_new[kept.second]) continue;
        for (std::size_t i = 1; i < quads.size(); ++i) {
            const auto& [first, second, p, q, r, s] = quads[i];
            if (is_new[first] || is_new[second]) continue;
            if (!kept.hasDiagonal(r, s) || !isPlane(mesh, kept, tolerance)) continue;
            mesh.triangles[first] = {r, p, s};
            mesh.triangles[second] = {s, q, r};
            is_new[first] = is_new[second] = 1;
        }
    }
}

}  // namespace sherd
