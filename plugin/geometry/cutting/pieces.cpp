#include "geometry/cutting/pieces.h"

#include <algorithm>
#include <map>

#include "core/numerics/union_find.h"
#include "geometry/cutting/point_location.h"
#include "geometry/mass_properties.h"

namespace sherd {

namespace {

// Less than this part of a particle is no fragment.
constexpr double smallest_piece = 0.05;

/// The triangles that bound the labels: those of the body, then both sides of every crack face.
struct Boundary {
    std::vector<Triangle> triangles;
    std::vector<int> labels;
    int body_count = 0;

    // The other side of a crack face.
    int opposite(int t) const { return t < body_count ? -1 : body_count + ((t - body_count) ^ 1); }
};

/// A set of boundary triangles.
struct Shell {
    std::vector<int> triangles;
    int label = -1;
    double volume = 0;  ///< m^3; negative: a cavity
    Vec3 low, high;
};

Boundary makeBoundary(const CutFaces& faces) {
    Boundary boundary;
    boundary.triangles.reserve(faces.body.size() + 2 * faces.crack.size());
    boundary.labels.reserve(faces.body.size() + 2 * faces.crack.size());
    boundary.triangles = faces.body;
    boundary.labels = faces.body_label;
    boundary.body_count = static_cast<int>(faces.body.size());
    for (std::size_t c = 0; c < faces.crack.size(); ++c) {
        const auto& [p, q, r] = faces.crack[c];
        // The normal points out of the label below and into the label above.
        boundary.triangles.push_back({p, q, r});
        boundary.triangles.push_back({p, r, q});
        boundary.labels.push_back(faces.crack_sides[c].below);
        boundary.labels.push_back(faces.crack_sides[c].above);
    }
    return boundary;
}

std::vector<char> findCrackPoints(const Boundary& boundary, std::size_t point_count) {
    std::vector<char> on_crack(point_count, false);
    for (std::size_t t = boundary.body_count; t < boundary.triangles.size(); ++t)
        for (int v : boundary.triangles[t]) on_crack[v] = true;
    return on_crack;
}

std::vector<int> trianglesAt(const Boundary& boundary, const std::vector<char>& marked) {
    std::vector<int> selected;
    for (std::size_t t = 0; t < boundary.triangles.size(); ++t) {
        const auto& [a, b, c] = boundary.triangles[t];
        if (marked[a] || marked[b] || marked[c]) selected.push_back(static_cast<int>(t));
    }
    return selected;
}

// At every edge that ends in a crack the triangles of each label come in one pair of opposite directions.
// False if not: the surface is open. All other edges are those of the body, which is closed.
bool connectShells(const Boundary& boundary, const CutFaces& faces, UnionFind& sets) {
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

double signedVolumeOf(const std::vector<int>& members, const std::vector<Triangle>& triangles,
                      const std::vector<Vec3>& points, const Vec3& origin) {
    double six_volumes = 0;
    for (int t : members) {
        const auto& [a, b, c] = triangles[t];
        six_volumes += (points[a] - origin).cross(points[b] - origin).dot(points[c] - origin);
    }
    return six_volumes / 6;
}

std::vector<Shell> collectShells(const Boundary& boundary, const std::vector<Vec3>& points,
                                 const Vec3& origin, UnionFind& sets) {
    std::vector<int> shell_of(boundary.triangles.size(), -1);
    std::vector<Shell> shells;
    for (int t = 0; t < static_cast<int>(boundary.triangles.size()); ++t) {
        int& index = shell_of[sets.root(t)];
        if (index < 0) {
            index = static_cast<int>(shells.size());
            shells.emplace_back();
            shells.back().label = boundary.labels[t];
            shells.back().low = shells.back().high = points[boundary.triangles[t][0]];
        }
        Shell& shell = shells[index];
        shell.triangles.push_back(t);
        for (int v : boundary.triangles[t]) {
            shell.low = shell.low.cwiseMin(points[v]);
            shell.high = shell.high.cwiseMax(points[v]);
        }
    }
    for (Shell& shell : shells)
        shell.volume = signedVolumeOf(shell.triangles, boundary.triangles, points, origin);
    return shells;
}

bool contains(const Shell& shell, const Vec3& x, const Boundary& boundary, const std::vector<Vec3>& points) {
    if ((x.array() < shell.low.array()).any() || (x.array() > shell.high.array()).any()) return false;
    std::vector<Triangle> triangles;
    for (int t : shell.triangles) triangles.push_back(boundary.triangles[t]);
    return isInside(x, points, triangles);
}

// A cavity joins the smallest shell of its label around it. False if there is none.
bool attachCavities(const Boundary& boundary, const std::vector<Vec3>& points, std::vector<Shell>& shells) {
    for (Shell& cavity : shells) {
        if (cavity.volume >= 0) continue;
        const Vec3& x = points[boundary.triangles[cavity.triangles.front()][0]];
        Shell* around = nullptr;
        for (Shell& shell : shells)
            if (shell.volume > 0 && shell.label == cavity.label &&
                (!around || shell.volume < around->volume) && contains(shell, x, boundary, points))
                around = &shell;
        if (!around) return false;
        around->triangles.insert(around->triangles.end(), cavity.triangles.begin(), cavity.triangles.end());
        around->volume += cavity.volume;
        cavity.triangles.clear();
    }
    shells.erase(
        std::remove_if(shells.begin(), shells.end(), [](const Shell& s) { return s.triangles.empty(); }),
        shells.end());
    return true;
}

// Whether a piece is a fragment of its own rather than a place where the smoothed labels reached across a
// gap.
std::vector<char> findStrays(const std::vector<Shell>& shells, const Boundary& boundary,
                             const std::vector<Vec3>& points, const Discretisation& solid,
                             const FragmentLabels& labels) {
    double mean_volume = 0;
    for (const Particle& p : solid.particles)
        mean_volume += p.volume / static_cast<double>(solid.particles.size());
    std::map<int, std::vector<int>> of_label;
    for (int s = 0; s < static_cast<int>(shells.size()); ++s) of_label[shells[s].label].push_back(s);
    std::vector<char> is_stray(shells.size(), false);
    for (const auto& [label, members] : of_label) {
        const int largest = *std::max_element(members.begin(), members.end(), [&](int a, int b) {
            return shells[a].volume < shells[b].volume;
        });
        for (int s : members) {
            is_stray[s] = shells[s].volume < smallest_piece * mean_volume;
            if (is_stray[s] || s == largest) continue;
            bool holds_particle = false;
            for (std::size_t i = 0; i < solid.particles.size() && !holds_particle; ++i)
                holds_particle = labels.of_particle[i] == label &&
                                 contains(shells[s], solid.particles[i].position, boundary, points);
            is_stray[s] = !holds_particle;
        }
    }
    return is_stray;
}

// The shell of every boundary triangle.
std::vector<int> shellOf(const std::vector<Shell>& shells, const Boundary& boundary) {
    std::vector<int> shell_of(boundary.triangles.size(), -1);
    for (std::size_t s = 0; s < shells.size(); ++s)
        for (int t : shells[s].triangles) shell_of[t] = static_cast<int>(s);
    return shell_of;
}

// Crack area that each piece shares with each neighbour, m^2.
std::vector<std::map<int, double>> contactAreas(const std::vector<Shell>& shells, const Boundary& boundary,
                                                const std::vector<Vec3>& points) {
    const std::vector<int> piece_of = shellOf(shells, boundary);
    std::vector<std::map<int, double>> areas(shells.size());
    for (int t = boundary.body_count; t < static_cast<int>(boundary.triangles.size()); ++t) {
        const auto& [a, b, c] = boundary.triangles[t];
        areas[piece_of[t]][piece_of[boundary.opposite(t)]] +=
            (points[b] - points[a]).cross(points[c] - points[a]).norm() / 2;
    }
    return areas;
}

// Strays join their neighbours, the smallest first; the crack faces between them vanish. The result maps
// every shell to the one it is part of.
std::vector<int> mergeStrays(const std::vector<Shell>& shells, const Boundary& boundary,
                             const std::vector<Vec3>& points, const std::vector<char>& is_stray) {
    const auto areas = contactAreas(shells, boundary, points);
    std::vector<int> order;
    for (int s = 0; s < static_cast<int>(shells.size()); ++s)
        if (is_stray[s]) order.push_back(s);
    std::sort(order.begin(), order.end(), [&](int a, int b) {
        return std::make_pair(shells[a].volume, a) < std::make_pair(shells[b].volume, b);
    });
    std::vector<int> joined(shells.size());
    for (std::size_t s = 0; s < joined.size(); ++s) joined[s] = static_cast<int>(s);
    const auto end = [&](int s) {
        while (joined[s] != s) s = joined[s];
        return s;
    };
    for (int s : order) {
        int best = -1;
        double most = 0;
        for (const auto& [other, area] : areas[s])
            if (area > most && end(other) != s) best = end(other), most = area;
        if (best >= 0) joined[s] = best;
    }
    for (int& s : joined) s = end(s);
    return joined;
}

FragmentSurface extract(const Shell& shell, const Boundary& boundary, const TriangleMesh& body,
                        const CutFaces& faces, const std::vector<int>& piece_of,
                        std::vector<int>& new_index) {
    FragmentSurface piece;
    piece.label = shell.label;
    piece.mesh.vertices.reserve(shell.triangles.size() / 2 + 2);
    piece.mesh.triangles.reserve(shell.triangles.size());
    piece.mesh.kinds.reserve(shell.triangles.size());
    piece.parents.reserve(shell.triangles.size());
    piece.across.reserve(shell.triangles.size());
    for (int t : shell.triangles) {
        Triangle triangle = boundary.triangles[t];
        for (int& v : triangle) {
            if (new_index[v] < 0) {
                new_index[v] = static_cast<int>(piece.mesh.vertices.size());
                piece.mesh.vertices.push_back(faces.points[v]);
            }
            v = new_index[v];
        }
        const int parent = t < boundary.body_count ? faces.body_parent[t] : -1;
        piece.mesh.triangles.push_back(triangle);
        piece.parents.push_back(parent);
        piece.across.push_back(parent < 0 ? piece_of[boundary.opposite(t)] : -1);
        piece.mesh.kinds.push_back(parent < 0           ? SurfaceKind::crack
                                   : body.kinds.empty() ? SurfaceKind::original
                                                        : body.kinds[parent]);
    }
    for (int t : shell.triangles)
        for (int v : boundary.triangles[t]) new_index[v] = -1;
    return piece;
}

void applyMerges(const std::vector<int>& joined, const Boundary& boundary, std::vector<Shell>& shells) {
    std::vector<int> piece_of = shellOf(shells, boundary);
    for (int& piece : piece_of) piece = joined[piece];
    for (std::size_t s = 0; s < shells.size(); ++s) {
        if (joined[s] == static_cast<int>(s)) continue;
        Shell& target = shells[joined[s]];
        target.triangles.insert(target.triangles.end(), shells[s].triangles.begin(),
                                shells[s].triangles.end());
        target.volume += shells[s].volume;
        shells[s].triangles.clear();
    }
    for (Shell& shell : shells) {
        const auto vanished = [&](int t) {
            return t >= boundary.body_count && piece_of[t] == piece_of[boundary.opposite(t)];
        };
        shell.triangles.erase(std::remove_if(shell.triangles.begin(), shell.triangles.end(), vanished),
                              shell.triangles.end());
        std::sort(shell.triangles.begin(), shell.triangles.end());
    }
    shells.erase(
        std::remove_if(shells.begin(), shells.end(), [](const Shell& s) { return s.triangles.empty(); }),
        shells.end());
}

}  // namespace

Result<std::vector<FragmentSurface>> assemblePieces(const TriangleMesh& body, const CutFaces& faces,
                                                    const Discretisation& solid,
                                                    const FragmentLabels& labels) {
    const Boundary boundary = makeBoundary(faces);
    UnionFind sets(static_cast<int>(boundary.triangles.size()));
    if (!connectShells(boundary, faces, sets)) return Error{"a fragment would be open"};
    const Vec3 origin = body.vertices.front();
    std::vector<Shell> shells = collectShells(boundary, faces.points, origin, sets);
    if (!attachCavities(boundary, faces.points, shells)) return Error{"a cavity has no fragment around it"};
    applyMerges(mergeStrays(shells, boundary, faces.points,
                            findStrays(shells, boundary, faces.points, solid, labels)),
                boundary, shells);

    std::vector<FragmentSurface> pieces;
    const std::vector<int> piece_of = shellOf(shells, boundary);
    std::vector<int> new_index(faces.points.size(), -1);
    for (const Shell& shell : shells) {
        if (!(shell.volume > 0)) return Error{"a fragment would have no volume"};
        pieces.push_back(extract(shell, boundary, body, faces, piece_of, new_index));
    }
    return pieces;
}

double volumeRatio(const TriangleMesh& body, const std::vector<FragmentSurface>& pieces) {
    const Vec3& origin = body.vertices.front();
    double sum = 0;
    for (const FragmentSurface& piece : pieces) sum += enclosedVolume(piece.mesh, origin);
    return sum / enclosedVolume(body, origin);
}

}  // namespace sherd
