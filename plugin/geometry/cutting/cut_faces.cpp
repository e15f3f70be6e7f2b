#include "geometry/cutting/cut_faces.h"

#include <algorithm>
#include <utility>

#include "core/numerics/union_find.h"
#include "geometry/cutting/point_location.h"
#include "geometry/cutting/triangle_subdivision.h"

namespace sherd {

namespace {

/// Segments sorted by the triangle that they lie in.
struct SegmentGroups {
    std::vector<int> first;  // #T + 1, offsets into `segments`
    std::vector<int> segments;

    bool isEmpty(int t) const { return first[t] == first[t + 1]; }
};

/// One of the two surfaces, its edges and its crossings, with points numbered as in `SurfaceCrossing`.
struct Side {
    std::vector<Triangle> triangles;
    const EdgeTable& edges;
    const std::vector<EdgeCrossing>& on_edges;
    SegmentGroups groups;
};

/// Triangles of one of the two surfaces after splitting.
struct SplitSurface {
    std::vector<Triangle> triangles;
    std::vector<int> parents;
    std::vector<int> first_part;  // #parents + 1
};

// Corners and crossings along the edges of a triangle, counter-clockwise.
std::vector<int> boundaryLoop(const Side& side, int triangle) {
    std::vector<int> loop;
    for (int i = 0; i < 3; ++i) {
        const int edge = side.edges.of_triangle[triangle][i];
        const auto [begin, end] =
            std::equal_range(side.on_edges.begin(), side.on_edges.end(), EdgeCrossing{edge, 0, 0, 0},
                             [](const EdgeCrossing& a, const EdgeCrossing& b) { return a.edge < b.edge; });
        loop.push_back(side.triangles[triangle][i]);
        const auto first = static_cast<long>(loop.size());
        for (auto crossing = begin; crossing != end; ++crossing) loop.push_back(crossing->point);
        const bool from_lower = side.triangles[triangle][i] < side.triangles[triangle][(i + 1) % 3];
        if (!from_lower) std::reverse(loop.begin() + first, loop.end());
    }
    return loop;
}

SplitSurface splitSurface(const Side& side, const SurfaceCrossing& crossing, std::vector<int>& troubled) {
    SplitSurface result;
    result.triangles.reserve(side.triangles.size() + 2 * crossing.points.size());
    result.first_part.reserve(side.triangles.size() + 1);
    TriangleSubdivision subdivision;
    std::vector<std::pair<int, int>> pairs;
    const std::vector<Vec3>& x = crossing.points;
    for (int t = 0; t < static_cast<int>(side.triangles.size()); ++t) {
        result.first_part.push_back(static_cast<int>(result.triangles.size()));
        if (side.groups.isEmpty(t)) {
            result.triangles.push_back(side.triangles[t]);
            continue;
        }
        pairs.clear();
        const auto begin = side.groups.segments.begin() + side.groups.first[t],
                   end = side.groups.segments.begin() + side.groups.first[t + 1];
        for (auto s = begin; s != end; ++s)
            pairs.emplace_back(crossing.segments[*s].source, crossing.segments[*s].target);
        const auto& [a, b, c] = side.triangles[t];
        if (!subdivision.split(x, (x[b] - x[a]).cross(x[c] - x[a]), boundaryLoop(side, t), pairs,
                               result.triangles))
            for (auto s = begin; s != end; ++s) troubled.push_back(crossing.segments[*s].crack_triangle);
    }
    result.first_part.push_back(static_cast<int>(result.triangles.size()));
    result.parents.resize(result.triangles.size());
    for (int t = 0; t < static_cast<int>(side.triangles.size()); ++t)
        std::fill(result.parents.begin() + result.first_part[t],
                  result.parents.begin() + result.first_part[t + 1], t);
    return result;
}

/// Values on both sides of a barrier edge, for the triangle that runs along it from source to target and the
/// other one.
struct SideValues {
    int left, right;
};

/// The triangles that lie in split parents, and their edges; those of whole ones are known from before.
struct PartEdges {
    std::vector<int> parts;  // in the split surface
    EdgeTable edges;         // of `parts`, by their place there
};

PartEdges findPartEdges(const Side& side, const SplitSurface& split, int point_count) {
    PartEdges result;
    std::vector<Triangle> triangles;
    for (std::size_t t = 0; t < split.triangles.size(); ++t) {
        if (side.groups.isEmpty(split.parents[t])) continue;
        result.parts.push_back(static_cast<int>(t));
        triangles.push_back(split.triangles[t]);
    }
    result.edges = buildEdgeTable(triangles, point_count);
    return result;
}

// Sets of triangles that hang together without crossing a segment.
UnionFind connectWithin(const Side& side, const SplitSurface& split, const PartEdges& part_edges,
                        const std::vector<char>& is_barrier) {
    UnionFind sets(static_cast<int>(split.triangles.size()));
    const auto& [parts, edges] = part_edges;
    for (std::size_t e = 0; e < edges.edges.size(); ++e)
        if (!is_barrier[e])
            for (int u = edges.first_use[e] + 1; u < edges.first_use[e + 1]; ++u)
                sets.unite(parts[edges.uses[u] / 3], parts[edges.uses[edges.first_use[e]] / 3]);
    // Whole triangles have no crossing on their edges: a split neighbour has a part with the same edge.
    for (std::size_t e = 0; e < side.edges.edges.size(); ++e) {
        int first = -1;
        for (int u = side.edges.first_use[e]; u < side.edges.first_use[e + 1]; ++u) {
            const int parent = side.edges.uses[u] / 3;
            int t = split.first_part[parent];
            if (!side.groups.isEmpty(parent)) {
                const Triangle& corners = side.triangles[parent];
                const int i = side.edges.uses[u] % 3, edge = edges.find(corners[i], corners[(i + 1) % 3]);
                if (edge < 0) break;
                t = parts[edges.uses[edges.first_use[edge]] / 3];
            }
            if (first >= 0) sets.unite(first, t);
            first = t;
        }
    }
    return sets;
}

/// Spreads the values that the segments give to the triangles beside them; -1 where no segment is in reach.
/// False if two segments disagree, or one is not an edge between two triangles.
bool spreadFromSegments(const Side& side, const SplitSurface& split, int point_count,
                        const std::vector<CutSegment>& segments, const std::vector<SideValues>& values,
                        std::vector<int>& value, std::vector<int>& set) {
    const PartEdges part_edges = findPartEdges(side, split, point_count);
    const auto& [parts, edges] = part_edges;
    std::vector<char> is_barrier(edges.edges.size(), false);
    std::vector<int> edge_of(segments.size());
    for (std::size_t s = 0; s < segments.size(); ++s) {
        edge_of[s] = edges.find(segments[s].source, segments[s].target);
        if (edge_of[s] < 0 || edges.first_use[edge_of[s] + 1] - edges.first_use[edge_of[s]] != 2)
            return false;
        is_barrier[edge_of[s]] = true;
    }
    UnionFind sets = connectWithin(side, split, part_edges, is_barrier);
    std::vector<int> of_set(split.triangles.size(), -1);
    for (std::size_t s = 0; s < segments.size(); ++s)
        for (int u = edges.first_use[edge_of[s]]; u < edges.first_use[edge_of[s] + 1]; ++u) {
            const int t = parts[edges.uses[u] / 3];
            const bool on_left = split.triangles[t][edges.uses[u] % 3] == segments[s].source;
            const int wanted = on_left ? values[s].left : values[s].right;
            int& known = of_set[sets.root(t)];
            if (known >= 0 && known != wanted) return false;
            known = wanted;
        }
    value.resize(split.triangles.size());
    set.resize(split.triangles.size());
    for (std::size_t t = 0; t < split.triangles.size(); ++t) {
        set[t] = sets.root(static_cast<int>(t));
        value[t] = of_set[set[t]];
    }
    return true;
}

// The label at a point of the solid that is not on a crack: on the way to the nearest lattice node either a
// crack is met, or none, and then it is the node's. -1 if the way is degenerate.
int labelAt(const Vec3& x, const LabelLattice& lattice, const CrackComplex& crack) {
    const Eigen::Vector3i node = ((x - lattice.origin) / lattice.spacing).array().round().cast<int>();
    const int index = lattice.index(node.x(), node.y(), node.z());
    const FirstHit hit = firstHit(x, lattice.nodes[index], crack.points, crack.triangles);
    if (hit.degenerate) return -1;
    if (hit.triangle < 0) return lattice.labels[index];
    return hit.above ? crack.sides[hit.triangle].above : crack.sides[hit.triangle].below;
}

// Shells that no crack crosses.
bool labelUntouchedShells(const TriangleMesh& body, const LabelLattice& lattice, const CrackComplex& crack,
                          CutFaces& faces) {
    std::vector<int> of_set(faces.body.size(), -1);
    for (std::size_t t = 0; t < faces.body.size(); ++t) {
        if (faces.body_label[t] >= 0) continue;
        int& label = of_set[faces.body_set[t]];
        for (int i = 0; i < 3 && label < 0; ++i)
            label = labelAt(body.vertices[faces.body[t][i]], lattice, crack);
        faces.body_label[t] = label;
    }
    // A degenerate first triangle leaves -1 where a later one of the same shell found the label.
    for (std::size_t t = 0; t < faces.body.size(); ++t)
        if (faces.body_label[t] < 0) faces.body_label[t] = of_set[faces.body_set[t]];
    return std::find(faces.body_label.begin(), faces.body_label.end(), -1) == faces.body_label.end();
}

// Crack faces inside the solid; whole parts that do not touch the surface are located.
void keepInsideCracks(const SplitSurface& split, const std::vector<int>& inside, const std::vector<int>& set,
                      const CrackComplex& crack, const TriangleMesh& body, CutFaces& faces) {
    std::vector<int> of_set(split.triangles.size(), -1);
    for (std::size_t t = 0; t < split.triangles.size(); ++t) {
        int is_inside = inside[t];
        if (is_inside < 0) {
            int& known = of_set[set[t]];
            if (known < 0)
                known = isInside(faces.points[split.triangles[t][0]], body.vertices, body.triangles);
            is_inside = known;
        }
        if (!is_inside) continue;
        faces.crack.push_back(split.triangles[t]);
        faces.crack_sides.push_back(crack.sides[split.parents[t]]);
    }
}

SegmentGroups groupSegments(const std::vector<CutSegment>& segments, int CutSegment::*triangle,
                            std::size_t count) {
    SegmentGroups groups;
    groups.first.assign(count + 1, 0);
    for (const CutSegment& s : segments) ++groups.first[s.*triangle + 1];
    for (std::size_t t = 1; t <= count; ++t) groups.first[t] += groups.first[t - 1];
    groups.segments.resize(segments.size());
    std::vector<int> next(groups.first.begin(), groups.first.end() - 1);
    for (std::size_t s = 0; s < segments.size(); ++s)
        groups.segments[next[segments[s].*triangle]++] = static_cast<int>(s);
    return groups;
}

std::vector<Triangle> shifted(std::vector<Triangle> triangles, int first) {
    for (Triangle& t : triangles)
        for (int& v : t) v += first;
    return triangles;
}

}  // namespace

CutAttempt cutFaces(const TriangleMesh& body, const EdgeTable& body_edges, const LabelLattice& lattice,
                    const CrackComplex& crack) {
    CutAttempt attempt;
    const EdgeTable crack_edges = buildEdgeTable(crack.triangles, static_cast<int>(crack.points.size()));
    SurfaceCrossing crossing = crossSurfaces(body, body_edges, crack, crack_edges);
    attempt.troubled = crossing.degenerate;
    if (!attempt.troubled.empty()) return attempt;

    const Side body_side = {
        body.triangles, body_edges, crossing.on_body_edges,
        groupSegments(crossing.segments, &CutSegment::body_triangle, body.triangles.size())};
    const Side crack_side = {
        shifted(crack.triangles, crossing.first_crack_point), crack_edges, crossing.on_crack_edges,
        groupSegments(crossing.segments, &CutSegment::crack_triangle, crack.triangles.size())};
    SplitSurface split_body = splitSurface(body_side, crossing, attempt.troubled);
    const SplitSurface split_crack = splitSurface(crack_side, crossing, attempt.troubled);
    if (!attempt.troubled.empty()) return attempt;

    CutFaces& faces = attempt.faces;
    std::vector<SideValues> labels, insides;
    for (const CutSegment& s : crossing.segments) {
        labels.push_back({crack.sides[s.crack_triangle].below, crack.sides[s.crack_triangle].above});
        insides.push_back({0, 1});
    }
    const int point_count = static_cast<int>(crossing.points.size());
    std::vector<int> inside, crack_set;
    if (!spreadFromSegments(body_side, split_body, point_count, crossing.segments, labels, faces.body_label,
                            faces.body_set) ||
        !spreadFromSegments(crack_side, split_crack, point_count, crossing.segments, insides, inside,
                            crack_set)) {
        attempt.failure = "the lines of the crack on the surface do not close";
        return attempt;
    }
    faces.points = std::move(crossing.points);
    faces.body = std::move(split_body.triangles);
    faces.body_parent = std::move(split_body.parents);
    if (!labelUntouchedShells(body, lattice, crack, faces)) {
        attempt.failure = "a part of the surface could not be told from its neighbours";
    } else {
        keepInsideCracks(split_crack, inside, crack_set, crack, body, faces);
    }
    return attempt;
}

}  // namespace sherd
