#include "geometry/cutting/marching_tetrahedra.h"

#include <algorithm>

#include "geometry/cutting/crack_planes.h"

namespace sherd {

namespace {

// The place on the edge where the labels of its ends are equally dense: where the contrast (f_a - f_b) / (f_a
// + f_b), taken as linear, is zero. Unlike the densities it does not change when both fade into the air.
double crossingOnEdge(const LabelLattice& lattice, int a, int b) {
    if (lattice.cracks)
        return clampToEdge(crackOnEdge(lattice, a, b).value_or(0.5), lattice.smallest_edge_place);
    const int la = lattice.labels[a], lb = lattice.labels[b];
    const auto contrast = [&](int node, int own, int other) {
        const double f = lattice.densities.largest(node, own), g = lattice.densities.largest(node, other);
        return f + g > 0 ? (f - g) / (f + g) : 0;
    };
    const double at_a = contrast(a, la, lb), at_b = contrast(b, lb, la);
    return at_a + at_b > 0 ? clampToEdge(at_a / (at_a + at_b), lattice.smallest_edge_place) : 0.5;
}

/// The points on lattice edges and faces by their nodes, ascending; the third of an edge is -1. Each hangs on
/// its lowest node, which has few.
class PointsByNodes {
  public:
    explicit PointsByNodes(std::size_t node_count) : latest_(node_count, -1) {}

    int find(const std::array<int, 3>& nodes) const {
        for (int e = latest_[nodes[0]]; e >= 0; e = entries_[e].next)
            if (entries_[e].second == nodes[1] && entries_[e].third == nodes[2]) return entries_[e].point;
        return -1;
    }

    int add(const std::array<int, 3>& nodes, int point) {
        entries_.push_back({nodes[1], nodes[2], point, latest_[nodes[0]]});
        latest_[nodes[0]] = static_cast<int>(entries_.size()) - 1;
        return point;
    }

  private:
    struct Entry {
        int second, third, point, next;
    };
    std::vector<int> latest_;  // #nodes, or -1
    std::vector<Entry> entries_;
};

/// Builds the complex tetrahedron by tetrahedron; each point on a lattice edge or face is made once.
class Marching {
  public:
    explicit Marching(const LabelLattice& lattice) : lattice_(lattice), points_(lattice.nodes.size()) {}

    void addTetrahedron(const std::array<int, 4>& nodes) {
        std::array<int, 4> n = nodes;
        // Brings nodes of equal label side by side.
        std::sort(n.begin(), n.end(),
                  [&](int a, int b) { return std::make_pair(label(a), a) < std::make_pair(label(b), b); });
        const bool same[3] = {label(n[0]) == label(n[1]), label(n[1]) == label(n[2]),
                              label(n[2]) == label(n[3])};
        const int equal = same[0] + same[1] + same[2];
        if (equal == 3) return;
        if (equal == 2)
            return same[1] ? (same[0] ? addCorner(n[3], n[0], n[1], n[2]) : addCorner(n[0], n[1], n[2], n[3]))
                           : addQuad(n[0], n[1], n[2], n[3]);
        if (equal == 0) return addFourLabels(n);
        if (same[0]) return addThreeLabels(n[0], n[1], n[2], n[3]);
        if (same[1]) return addThreeLabels(n[1], n[2], n[0], n[3]);
        addThreeLabels(n[2], n[3], n[0], n[1]);
    }

    int triangleCount() const { return static_cast<int>(complex_.triangles.size()); }

    CrackComplex take(std::vector<int> first_of_cell) {
        complex_.first_of_cell = std::move(first_of_cell);
        return std::move(complex_);
    }

  private:
    int label(int node) const { return lattice_.labels[node]; }

    // The three other nodes share a label.
    void addCorner(int lone, int a, int b, int c) {
        addTriangle(onEdge(lone, a), onEdge(lone, b), onEdge(lone, c), lone, a);
    }

    // Nodes a and b share a label, c and d another one.
    void addQuad(int a, int b, int c, int d) {
        const int ac = onEdge(a, c), ad = onEdge(a, d), bd = onEdge(b, d), bc = onEdge(b, c);
        addTriangle(ac, ad, bd, a, c);
        addTriangle(ac, bd, bc, b, c);
    }

    // Nodes a and a2 share a label. The faces between the three labels meet along the line between two points
    // on faces of the tetrahedron.
    void addThreeLabels(int a, int a2, int b, int c) {
        const int f = onFace(a, b, c), f2 = onFace(a2, b, c);
        addTriangle(onEdge(b, c), f, f2, b, c);
        for (int other : {b, c}) {
            addTriangle(onEdge(a, other), f, f2, a, other);
            addTriangle(onEdge(a, other), f2, onEdge(a2, other), a, other);
        }
    }

    // The faces are cones from an inner point over the lines in which the labels meet on the tetrahedron's
    // faces.
    void addFourLabels(const std::array<int, 4>& n) {
        CrackPoint centre;
        centre.between = {onFace(n[0], n[1], n[2]), onFace(n[0], n[1], n[3]), onFace(n[0], n[2], n[3]),
                          onFace(n[1], n[2], n[3])};
        const int inner = addPoint(centre);
        for (int i = 0; i < 4; ++i)
            for (int j = i + 1; j < 4; ++j)
                for (int k = 0; k < 4; ++k)
                    if (k != i && k != j)
                        addTriangle(inner, onEdge(n[i], n[j]), onFace(n[i], n[j], n[k]), n[i], n[j]);
    }

    // Orients the triangle from the label of node `from` to that of node `to`. One of its corners lies on the
    // edge between the two nodes, so that they are on different sides of its plane.
    void addTriangle(int p, int q, int r, int from, int to) {
        const std::vector<Vec3>& x = complex_.points;
        const Vec3 normal = (x[q] - x[p]).cross(x[r] - x[p]);
        if (normal.dot(lattice_.nodes[to] - lattice_.nodes[from]) < 0) std::swap(q, r);
        complex_.triangles.push_back({p, q, r});
        complex_.sides.push_back({label(from), label(to)});
    }

    int onEdge(int a, int b) {
        if (a > b) std::swap(a, b);
        if (const int known = points_.find({a, b, -1}); known >= 0) return known;
        CrackPoint point;
        point.nodes[0] = a;
        point.nodes[1] = b;
        point.t = crossingOnEdge(lattice_, a, b);
        return points_.add({a, b, -1}, addPoint(point));
    }

    int onFace(int a, int b, int c) {
        std::array<int, 3> key = {a, b, c};
        std::sort(key.begin(), key.end());
        if (const int known = points_.find(key); known >= 0) return known;
        CrackPoint point;
        point.between = {onEdge(a, b), onEdge(b, c), onEdge(a, c), -1};
        point.weights = {1.0 / 3, 1.0 / 3, 1.0 / 3, 0};
        constexpr double least = 0.03;
        const auto exact = lattice_.cracks ? crackJunction(lattice_, a, b, c) : std::nullopt;
        if (exact) placeInFace(point, complex_, *exact, least);
        return points_.add(key, addPoint(point));
    }

    int addPoint(const CrackPoint& origin) {
        complex_.origins.push_back(origin);
        complex_.points.push_back(positionOf(origin, complex_, lattice_));
        return static_cast<int>(complex_.points.size()) - 1;
    }

    const LabelLattice& lattice_;
    CrackComplex complex_;
    PointsByNodes points_;
};

// The six tetrahedra of a cube, by the steps from its lowest node to the three others: Freudenthal's, the
// paths from its lowest to its highest corner. Neighbouring cubes match.
std::vector<std::array<int, 3>> tetrahedraOfCell(const LatticeGrid& grid) {
    const int step[3] = {grid.index(1, 0, 0), grid.index(0, 1, 0), grid.index(0, 0, 1)};
    std::vector<std::array<int, 3>> tetrahedra;
    for (int first = 0; first < 3; ++first)
        for (int second = 0; second < 3; ++second)
            if (first != second)
                tetrahedra.push_back({step[first], step[first] + step[second], step[0] + step[1] + step[2]});
    return tetrahedra;
}

/// Whether all corners of a cell have the same label.
class Uniformity {
  public:
    explicit Uniformity(const LabelLattice& lattice) : labels_(lattice.labels) {
        for (int corner = 1; corner < 8; ++corner) steps_[corner - 1] = lattice.stepToCorner(corner);
    }
    bool operator()(int cell) const {
        const int* const at = labels_.data() + cell;
        return std::all_of(steps_.begin(), steps_.end(), [&](int step) { return at[step] == *at; });
    }

  private:
    const std::vector<int>& labels_;
    std::array<int, 7> steps_{};
};

}  // namespace

CrackComplex buildCrackComplex(const LabelLattice& lattice) {
    Marching marching(lattice);
    std::vector<int> first_of_cell;
    first_of_cell.reserve(lattice.layout->active_cells.size() + 1);
    const auto tetrahedra = tetrahedraOfCell(lattice);
    const Uniformity is_uniform(lattice);
    for (const int cell : lattice.layout->active_cells) {
        first_of_cell.push_back(marching.triangleCount());
        if (is_uniform(cell)) continue;
        for (const auto& [second, third, fourth] : tetrahedra)
            marching.addTetrahedron({cell, cell + second, cell + third, cell + fourth});
    }
    first_of_cell.push_back(marching.triangleCount());
    return marching.take(std::move(first_of_cell));
}

}  // namespace sherd
