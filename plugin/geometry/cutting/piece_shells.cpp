#include "geometry/cutting/piece_shells.h"

#include <algorithm>
#include <utility>

#include "core/numerics/parallel_chunks.h"
#include "core/numerics/union_find.h"
#include "geometry/cutting/point_location.h"

namespace sherd {

namespace {

// A triangle that runs along an edge.
struct EdgeSide {
    int triangle, label;
    bool from_lower;  // it runs from the edge's lower vertex to the higher one
};

/// The half-edges with an end on a crack, by their lower vertex: those of the body's triangles, and one side
/// of every crack face.
class CrackEdges {
  public:
    CrackEdges(const LabelBoundary& boundary, const CutFaces& faces)
        : boundary_(boundary), first_(faces.points.size() + 1, 0) {
        collect(faces.body_point_count);
        std::vector<HalfEdge> sorted(found_.size());
        for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
        std::vector<int> next(first_.begin(), first_.end() - 1);
        for (const HalfEdge& half_edge : found_) sorted[next[half_edge.lower]++] = half_edge;
        found_ = std::move(sorted);
    }

    /// Calls visit(sides) for each edge with all triangles along it, both sides of crack faces among them,
    /// until one is refused.
    template <class Visit>
    bool forEach(const Visit& visit) {
        for (std::size_t v = 0; v + 1 < first_.size(); ++v) {
            if (first_[v] == first_[v + 1]) continue;
            HalfEdge* const begin = found_.data() + first_[v];
            HalfEdge* const end = found_.data() + first_[v + 1];
            for (HalfEdge* edge = begin; edge != end;) {
                sides_.clear();
                HalfEdge* other = edge;
                for (HalfEdge* h = edge; h != end; ++h) {
                    if (h->higher != edge->higher) continue;
                    addSides(*h);
                    std::swap(*h, *other++);
                }
                edge = other;
                if (!visit(sides_)) return false;
            }
        }
        return true;
    }

  private:
    struct HalfEdge {
        int lower, higher, triangle;
        bool from_lower;
    };

    /// Points on cracks have numbers from `first_on_crack` on.
    void collect(int first_on_crack) {
        const int count = static_cast<int>(boundary_.triangles.size());
        found_.reserve(3 * (boundary_.triangles.size() - boundary_.body_count));
        for (int t = 0; t < count; t += t < boundary_.body_count ? 1 : 2) {
            const Triangle& corners = boundary_.triangles[t];
            for (int i = 0; i < 3; ++i) {
                const int a = corners[i], b = corners[i < 2 ? i + 1 : 0];
                if (std::max(a, b) < first_on_crack) continue;
                found_.push_back({std::min(a, b), std::max(a, b), t, a < b});
                ++first_[std::min(a, b) + 1];
            }
        }
    }

    void addSides(const HalfEdge& h) {
        sides_.push_back({h.triangle, boundary_.labels[h.triangle], h.from_lower});
        const int opposite = boundary_.opposite(h.triangle);
        if (opposite >= 0) sides_.push_back({opposite, boundary_.labels[opposite], !h.from_lower});
    }

    const LabelBoundary& boundary_;
    std::vector<int> first_;  // #points + 1, offsets into `found_`
    std::vector<HalfEdge> found_;
    std::vector<EdgeSide> sides_;  // of one edge
};

// Unites the two triangles of each label; false if a label has not two that run in opposite directions.
bool uniteSides(const std::vector<EdgeSide>& sides, UnionFind& sets) {
    for (std::size_t s = 0; s < sides.size(); ++s) {
        int partners = 0;
        for (std::size_t k = 0; k < sides.size(); ++k) {
            if (k == s || sides[k].label != sides[s].label) continue;
            if (sides[k].from_lower == sides[s].from_lower) return false;
            if (k > s) sets.unite(sides[s].triangle, sides[k].triangle);
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
    CrackEdges edges(boundary, faces);
    return edges.forEach([&](const std::vector<EdgeSide>& sides) { return uniteSides(sides, sets); });
}

std::vector<Triangle> trianglesOf(const PieceShell& shell, const LabelBoundary& boundary) {
    std::vector<Triangle> triangles;
    triangles.reserve(shell.triangles.size());
    for (int t : shell.triangles) triangles.push_back(boundary.triangles[t]);
    return triangles;
}

// Of the surface of a shell.
double signedVolumeOf(const PieceShell& shell, const LabelBoundary& boundary, const std::vector<Vec3>& points,
                      const Vec3& origin) {
    double six_volumes = 0;
    for (const int t : shell.triangles) {
        const auto& [a, b, c] = boundary.triangles[t];
        six_volumes += (points[a] - origin).cross(points[b] - origin).dot(points[c] - origin);
    }
    return six_volumes / 6;
}

// The united sets, in the order of their first triangles. Cavities are shells with a negative volume.
std::vector<PieceShell> collectShells(const LabelBoundary& boundary, const std::vector<Vec3>& points,
                                      const Vec3& origin, UnionFind& sets) {
    const int count = static_cast<int>(boundary.triangles.size());
    std::vector<int> shell_of(count), sizes;  // the root of a set is its first triangle
    std::vector<PieceShell> shells;
    for (int t = 0; t < count; ++t) {
        const int root = sets.root(t);
        if (root == t) {
            shell_of[t] = static_cast<int>(sizes.size());
            sizes.push_back(0);
            shells.emplace_back();
            shells.back().label = boundary.labels[t];
        }
        shell_of[t] = shell_of[root];
        ++sizes[shell_of[t]];
    }
    for (std::size_t s = 0; s < shells.size(); ++s) shells[s].triangles.reserve(sizes[s]);
    for (int t = 0; t < count; ++t) shells[shell_of[t]].triangles.push_back(t);
    forEachChunk(static_cast<int>(shells.size()),
                 [&](int s) { shells[s].volume = signedVolumeOf(shells[s], boundary, points, origin); });
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
