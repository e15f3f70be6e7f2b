#include "geometry/cutting/chain_subdivision.h"

#include <algorithm>

namespace sherd {

bool ChainSubdivision::split(const std::vector<Vec3>& points, const Vec3& normal,
                             const std::vector<int>& loop, const std::vector<std::pair<int, int>>& segments,
                             std::vector<Triangle>& out, TrianglePolygons& polygons) {
    constexpr std::size_t most_points = 60;  // what follows searches linearly
    if (loop.size() + segments.size() > most_points) return false;
    points_.clear();
    triangles_.clear();
    for (const int id : loop) points_.push_back({id, project(points[id], normal), {-1, -1}, {-1, -1}, 0});
    if (!connect(points, normal, segments)) return false;
    const int edge_count = static_cast<int>(loop.size());
    polygons.count = 0;
    polygons.of_part.clear();
    polygons.at_edge.assign(loop.size(), -1);
    polygons.beside_segments.resize(segments.size());
    for (int edge = 0; edge < edge_count; ++edge)
        if (polygons.at_edge[edge] < 0 && !addPolygon(edge, edge_count, polygons)) return false;
    // Euler: a polygon with n points on its loop and m inside has n + 2 m - 2 triangles. There are fewer
    // where chains cross, or where some are closed.
    if (triangles_.size() != 2 * points_.size() - loop.size() - 2) return false;
    for (const auto& [a, b, c] : triangles_) out.push_back({points_[a].id, points_[b].id, points_[c].id});
    return true;
}

// Notes the neighbours along segments; false unless the ends of all chains are on the loop.
bool ChainSubdivision::connect(const std::vector<Vec3>& points, const Vec3& normal,
                               const std::vector<std::pair<int, int>>& segments) {
    const std::size_t on_loop = points_.size();
    int way = 0;
    for (const auto& [source, target] : segments) {
        const int a = localOf(source, points, normal), b = localOf(target, points, normal);
        if (a == b || points_[a].degree == 2 || points_[b].degree == 2) return false;
        points_[a].ways[points_[a].degree] = way++;
        points_[a].neighbours[points_[a].degree++] = b;
        points_[b].ways[points_[b].degree] = way++;
        points_[b].neighbours[points_[b].degree++] = a;
    }
    for (std::size_t p = 0; p < points_.size(); ++p)
        if (p < on_loop ? points_[p].degree > 1 : points_[p].degree != 2) return false;
    return true;
}

int ChainSubdivision::localOf(int id, const std::vector<Vec3>& points, const Vec3& normal) {
    for (std::size_t p = 0; p < points_.size(); ++p)
        if (points_[p].id == id) return static_cast<int>(p);
    points_.push_back({id, project(points[id], normal), {-1, -1}, {-1, -1}, 0});
    return static_cast<int>(points_.size()) - 1;
}

// Walks around the polygon on the left of an edge of the loop: where a chain begins it follows that one to
// its end on the loop.
bool ChainSubdivision::addPolygon(int first_edge, int edge_count, TrianglePolygons& polygons) {
    polygon_.clear();
    int edge = first_edge;
    do {
        if (polygons.at_edge[edge] >= 0) return false;
        polygons.at_edge[edge] = polygons.count;
        polygon_.push_back(edge);
        const int at = edge + 1 < edge_count ? edge + 1 : 0;
        edge = points_[at].degree == 1 ? followChain(at, edge_count, polygons) : at;
    } while (edge != first_edge);
    if (!triangulatePolygon()) return false;
    polygons.of_part.resize(triangles_.size(), polygons.count++);
    return true;
}

// Adds its points to the polygon on its left, but for the last, which is returned.
int ChainSubdivision::followChain(int at, int edge_count, TrianglePolygons& polygons) {
    int slot = 0;
    do {
        const int way = points_[at].ways[slot], before = at;
        polygons.beside_segments[way / 2][way % 2] = polygons.count;
        polygon_.push_back(at);
        at = points_[at].neighbours[slot];
        slot = points_[at].neighbours[0] == before ? 1 : 0;
    } while (at >= edge_count);
    return at;
}

// Cuts off ears, then flips diagonals. All triangles are oriented as the polygon: rounding has turned none
// over.
bool ChainSubdivision::triangulatePolygon() {
    const std::size_t first = triangles_.size();
    while (polygon_.size() > 3) {
        std::size_t ear = 0;
        while (ear < polygon_.size() && !isEar(ear)) ++ear;
        if (ear == polygon_.size()) return false;
        const std::size_t count = polygon_.size();
        triangles_.push_back(
            {polygon_[(ear + count - 1) % count], polygon_[ear], polygon_[(ear + 1) % count]});
        polygon_.erase(polygon_.begin() + static_cast<long>(ear));
    }
    if (polygon_.size() != 3 || !isLeftTurn(polygon_[0], polygon_[1], polygon_[2])) return false;
    triangles_.push_back({polygon_[0], polygon_[1], polygon_[2]});
    flipToDelaunay(first);
    return true;
}

bool ChainSubdivision::isEar(std::size_t corner) const {
    const std::size_t count = polygon_.size(), before = (corner + count - 1) % count,
                      after = (corner + 1) % count;
    const int a = polygon_[before], b = polygon_[corner], c = polygon_[after];
    if (!isLeftTurn(a, b, c)) return false;
    for (std::size_t k = 0; k < count; ++k) {
        if (k == before || k == corner || k == after) continue;
        const int p = polygon_[k];
        if (!isLeftTurn(b, a, p) && !isLeftTurn(c, b, p) && !isLeftTurn(a, c, p)) return false;
    }
    return true;
}

// Lawson's flips of the diagonals of the polygon whose triangles begin at `first`. Of two triangles the
// diagonal is right after one look.
void ChainSubdivision::flipToDelaunay(std::size_t first) {
    const std::size_t count = triangles_.size() - first;
    for (bool flipped = count > 1; flipped;) {
        flipped = false;
        for (std::size_t t = first + 1; t < triangles_.size(); ++t)
            for (int edge = 0; edge < 3; ++edge) flipped |= flipAcross(first, t, edge);
        if (count == 2) return;
    }
}

bool ChainSubdivision::flipAcross(std::size_t first, std::size_t triangle, int edge) {
    const int a = triangles_[triangle][edge], b = triangles_[triangle][(edge + 1) % 3],
              c = triangles_[triangle][(edge + 2) % 3];
    for (std::size_t other = first; other < triangle; ++other)
        for (int i = 0; i < 3; ++i) {
            if (triangles_[other][i] != b || triangles_[other][(i + 1) % 3] != a) continue;
            const int d = triangles_[other][(i + 2) % 3];
            if (CGAL::side_of_oriented_circle(points_[a].place, points_[b].place, points_[c].place,
                                              points_[d].place) != CGAL::ON_POSITIVE_SIDE)
                return false;
            triangles_[triangle] = {a, d, c};
            triangles_[other] = {d, b, c};
            return true;
        }
    return false;
}

bool ChainSubdivision::isLeftTurn(int a, int b, int c) const {
    return CGAL::orientation(points_[a].place, points_[b].place, points_[c].place) == CGAL::LEFT_TURN;
}

}  // namespace sherd
