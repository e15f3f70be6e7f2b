#include "geometry/canonical_hull.h"

#include <algorithm>
#include <vector>

#include "core/numerics/union_find.h"

namespace sherd {

namespace {

/// The faces of a hull, each of some of its triangles that lie in one plane.
UnionFind facesOf(const ExactMesh& hull) {
    UnionFind faces(hull.number_of_faces());
    for (const auto edge : hull.edges()) {
        const auto side = hull.halfedge(edge, 0), other = hull.halfedge(edge, 1);
        if (CGAL::coplanar(hull.point(hull.source(side)), hull.point(hull.target(side)),
                           hull.point(hull.target(hull.next(side))),
                           hull.point(hull.target(hull.next(other)))))
            faces.unite(static_cast<int>(hull.face(side)), static_cast<int>(hull.face(other)));
    }
    return faces;
}

/// Whether at least three faces meet in a vertex.
bool isCorner(const ExactMesh& hull, ExactMesh::Vertex_index vertex, UnionFind& faces) {
    std::vector<int> around;
    for (const auto face : CGAL::faces_around_target(hull.halfedge(vertex), hull)) {
        const int root = faces.root(static_cast<int>(face));
        if (std::find(around.begin(), around.end(), root) == around.end()) around.push_back(root);
    }
    return around.size() > 2;
}

using Loop = std::vector<int>;

/// Around each face, from its first corner on; the faces in the order of their corners.
std::vector<Loop> loopsOf(const ExactMesh& hull, UnionFind& faces, const std::vector<int>& number_of) {
    const auto root = [&](ExactMesh::Halfedge_index side) {
        return faces.root(static_cast<int>(hull.face(side)));
    };
    std::vector<char> is_walked(hull.number_of_faces(), 0);
    std::vector<Loop> loops;
    for (const auto start : hull.halfedges()) {
        const int face = root(start);
        if (root(hull.opposite(start)) == face || is_walked[face]) continue;
        is_walked[face] = 1;
        Loop loop;
        auto side = start;
        do {
            if (const int number = number_of[hull.target(side)]; number >= 0) loop.push_back(number);
            side = hull.next(side);
            while (root(hull.opposite(side)) == face) side = hull.next(hull.opposite(side));
        } while (side != start);
        std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
        loops.push_back(std::move(loop));
    }
    std::sort(loops.begin(), loops.end());
    return loops;
}

}  // namespace

ExactMesh canonicalHull(const ExactMesh& hull) {
    UnionFind faces = facesOf(hull);
    std::vector<ExactMesh::Vertex_index> corners;
    for (const auto vertex : hull.vertices())
        if (isCorner(hull, vertex, faces)) corners.push_back(vertex);
    std::sort(corners.begin(), corners.end(),
              [&](const auto a, const auto b) { return hull.point(a) < hull.point(b); });
    ExactMesh canonical;
    std::vector<int> number_of(hull.number_of_vertices(), -1);
    for (const auto corner : corners)
        number_of[corner] = static_cast<int>(canonical.add_vertex(hull.point(corner)));
    for (const Loop& loop : loopsOf(hull, faces, number_of))
        for (std::size_t i = 1; i + 1 < loop.size(); ++i)
            canonical.add_face(ExactMesh::Vertex_index(loop[0]), ExactMesh::Vertex_index(loop[i]),
                               ExactMesh::Vertex_index(loop[i + 1]));
    return canonical;
}

}  // namespace sherd
