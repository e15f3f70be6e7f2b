#include "geometry/cutting/crack_complex.h"

#include <algorithm>
#include <map>

#include "core/numerics/hashed_random.h"

namespace sherd {

namespace {

// Points keep this far from the nodes, so that no sliver appears and no piece of a label is thinner.
constexpr double smallest_t = 0.15;
constexpr double smallest_weight = 0.1;

// Where two labels are equally dense on the edge: the contrast (f_a - f_b) / (f_a + f_b) goes through zero.
// It does not change when both fade into the air.
double crossingOnEdge(const LabelLattice& lattice, int a, int b) {
    const int la = lattice.labels[a], lb = lattice.labels[b];
    const auto contrast = [&](int node, int own, int other) {
        const double f = lattice.density(node, own), g = lattice.density(node, other);
        return f + g > 0 ? (f - g) / (f + g) : 0;
    };
    const double at_a = contrast(a, la, lb), at_b = contrast(b, lb, la);
    return at_a + at_b > 0 ? clampToEdge(at_a / (at_a + at_b)) : 0.5;
}

Vec3 placeOf(const CrackComplex& complex, const LabelLattice& lattice, const CrackPoint& origin) {
    if (origin.nodes[0] >= 0)
        return (1 - origin.t) * lattice.nodes[origin.nodes[0]] + origin.t * lattice.nodes[origin.nodes[1]];
    Vec3 place = Vec3::Zero();
    for (int i = 0; i < 4; ++i)
        if (origin.between[i] >= 0) place += origin.weights[i] * complex.points[origin.between[i]];
    return place;
}

class Marching {
  public:
    explicit Marching(const LabelLattice& lattice) : lattice_(lattice) {}

    void addTetrahedron(const std::array<int, 4>& nodes) {
        std::array<int, 4> n = nodes;
        // Nodes of equal label side by side; the order of the labels does not matter.
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

    CrackComplex take() { return std::move(complex_); }

  private:
    int label(int node) const { return lattice_.labels[node]; }

    // One node of another label than the three others.
    void addCorner(int lone, int a, int b, int c) {
        addTriangle(onEdge(lone, a), onEdge(lone, b), onEdge(lone, c), lone, a);
    }

    // Nodes a, b of one label, c, d of another.
    void addQuad(int a, int b, int c, int d) {
        const int ac = onEdge(a, c), ad = onEdge(a, d), bd = onEdge(b, d), bc = onEdge(b, c);
        addTriangle(ac, ad, bd, a, c);
        addTriangle(ac, bd, bc, b, c);
    }

    // Nodes a and a2 share a label; three faces meet along the line between two points on the tetrahedron's
    // faces.
    void addThreeLabels(int a, int a2, int b, int c) {
        const int f = onFace(a, b, c), f2 = onFace(a2, b, c);
        addTriangle(onEdge(b, c), f, f2, b, c);
        for (int other : {b, c}) {
            addTriangle(onEdge(a, other), f, f2, a, other);
            addTriangle(onEdge(a, other), f2, onEdge(a2, other), a, other);
        }
    }

    // A cone from an inner point over the lines on the tetrahedron's faces.
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

    // The point on the edge between `from` and `to`, which have different labels, is one of p, q, r, so the
    // triangle's plane parts the two nodes and the sign below is safe.
    void addTriangle(int p, int q, int r, int from, int to) {
        const std::vector<Vec3>& x = complex_.points;
        const Vec3 normal = (x[q] - x[p]).cross(x[r] - x[p]);
        if (normal.dot(lattice_.nodes[to] - lattice_.nodes[from]) < 0) std::swap(q, r);
        complex_.triangles.push_back({p, q, r});
        complex_.sides.push_back({label(from), label(to)});
    }

    int onEdge(int a, int b) {
        if (a > b) std::swap(a, b);
        const auto [entry, is_new] = edge_points_.try_emplace({a, b}, -1);
        if (is_new) {
            CrackPoint point;
            point.nodes[0] = a;
            point.nodes[1] = b;
            point.t = crossingOnEdge(lattice_, a, b);
            entry->second = addPoint(point);
        }
        return entry->second;
    }

    int onFace(int a, int b, int c) {
        std::array<int, 3> key = {a, b, c};
        std::sort(key.begin(), key.end());
        const auto found = face_points_.find(key);
        if (found != face_points_.end()) return found->second;
        CrackPoint point;
        point.between = {onEdge(a, b), onEdge(b, c), onEdge(a, c), -1};
        point.weights = {1.0 / 3, 1.0 / 3, 1.0 / 3, 0};
        return face_points_[key] = addPoint(point);
    }

    int addPoint(const CrackPoint& origin) {
        complex_.origins.push_back(origin);
        complex_.points.push_back(placeOf(complex_, lattice_, origin));
        return static_cast<int>(complex_.points.size()) - 1;
    }

    const LabelLattice& lattice_;
    CrackComplex complex_;
    std::map<std::array<int, 2>, int> edge_points_;
    std::map<std::array<int, 3>, int> face_points_;
};

// Freudenthal's six tetrahedra of a cube: the paths from its lowest to its highest corner. Neighbouring cubes
// match.
void addCell(Marching& marching, const LabelLattice& lattice, int i, int j, int k) {
    const int lowest = lattice.index(i, j, k);
    const int step[3] = {lattice.index(1, 0, 0), lattice.index(0, 1, 0), lattice.index(0, 0, 1)};
    const int highest = lowest + step[0] + step[1] + step[2];
    for (int first = 0; first < 3; ++first)
        for (int second = 0; second < 3; ++second)
            if (first != second)
                marching.addTetrahedron(
                    {lowest, lowest + step[first], lowest + step[first] + step[second], highest});
}

bool isUniform(const LabelLattice& lattice, int i, int j, int k) {
    for (int corner = 1; corner < 8; ++corner)
        if (lattice.labels[lattice.index(i + corner % 2, j + corner / 2 % 2, k + corner / 4)] !=
            lattice.labels[lattice.index(i, j, k)])
            return false;
    return true;
}

// Sums over the neighbours of every point: on a sheet those of the sheet, on a line where sheets meet those
// of the line.
struct NeighbourMeans {
    std::vector<Vec3> sum;
    std::vector<int> count;
};

NeighbourMeans sumNeighbours(const CrackComplex& complex) {
    NeighbourMeans means = {std::vector<Vec3>(complex.points.size(), Vec3::Zero()),
                            std::vector<int>(complex.points.size(), 0)};
    const auto is_on_line = [&](int p) { return complex.origins[p].nodes[0] < 0; };
    for (const Triangle& t : complex.triangles)
        for (int i = 0; i < 3; ++i)
            for (int other : {t[(i + 1) % 3], t[(i + 2) % 3]}) {
                if (is_on_line(t[i]) && !is_on_line(other)) continue;
                means.sum[t[i]] += complex.points[other];
                ++means.count[t[i]];
            }
    return means;
}

double placeOnEdge(const CrackPoint& origin, const LabelLattice& lattice, const Vec3& wanted) {
    const Vec3 a = lattice.nodes[origin.nodes[0]], edge = lattice.nodes[origin.nodes[1]] - a;
    return clampToEdge((wanted - a).dot(edge) / edge.squaredNorm());
}

// The weights of the point of a lattice face that is nearest to the wanted one, kept strictly inside the
// triangle of the points on the face's edges: there the sheets of one tetrahedron cannot cross.
std::array<double, 4> weightsInFace(const CrackPoint& origin, const CrackComplex& complex,
                                    const Vec3& wanted) {
    const Vec3 &a = complex.points[origin.between[0]], &b = complex.points[origin.between[1]],
               &c = complex.points[origin.between[2]];
    const Vec3 normal = (b - a).cross(c - a);
    std::array<double, 4> w = {normal.dot((b - wanted).cross(c - wanted)),
                               normal.dot((c - wanted).cross(a - wanted)),
                               normal.dot((a - wanted).cross(b - wanted)), 0};
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += w[i] = std::max(smallest_weight, w[i] / normal.squaredNorm());
    for (double& weight : w) weight /= sum;
    return w;
}

// One damped step of every point toward the mean of its neighbours, within the edge or face that it belongs
// to.
void smoothOnce(CrackComplex& complex, const LabelLattice& lattice, bool with_sharp) {
    const NeighbourMeans means = sumNeighbours(complex);
    for (std::size_t p = 0; p < complex.points.size(); ++p) {
        CrackPoint& origin = complex.origins[p];
        if (means.count[p] == 0 || origin.between[3] >= 0 || origin.fixed) continue;
        if (!with_sharp && origin.nodes[0] >= 0 && lattice.isSharp(origin.nodes[0]) &&
            lattice.isSharp(origin.nodes[1]))
            continue;
        const Vec3 wanted = 0.5 * (complex.points[p] + means.sum[p] / means.count[p]);
        if (origin.nodes[0] >= 0)
            origin.t = placeOnEdge(origin, lattice, wanted);
        else
            origin.weights = weightsInFace(origin, complex, wanted);
    }
    placePoints(complex, lattice);
}

void nudgePoint(CrackComplex& complex, int point, std::uint64_t seed, int attempt) {
    CrackPoint& origin = complex.origins[point];
    if (origin.nodes[0] >= 0) {
        const double move =
            0.02 * hashedRandom(seed, static_cast<std::uint64_t>(point), static_cast<std::uint64_t>(attempt));
        const double moved = origin.t + move;
        origin.t = moved == clampToEdge(moved) ? moved : origin.t - move;
        return;
    }
    for (int p : origin.between)
        if (p >= 0) nudgePoint(complex, p, seed, attempt);
}

}  // namespace

double clampToEdge(double t) {
    return std::min(1 - smallest_t, std::max(smallest_t, t));
}

CrackComplex buildCrackComplex(const LabelLattice& lattice) {
    Marching marching(lattice);
    for (int k = 0; k + 1 < lattice.size.z(); ++k)
        for (int j = 0; j + 1 < lattice.size.y(); ++j)
            for (int i = 0; i + 1 < lattice.size.x(); ++i)
                if (lattice.active_cells[lattice.index(i, j, k)] && !isUniform(lattice, i, j, k))
                    addCell(marching, lattice, i, j, k);
    return marching.take();
}

void smoothCracks(CrackComplex& complex, const LabelLattice& lattice, int steps) {
    for (int step = 0; step < steps; ++step) smoothOnce(complex, lattice, step == 0);
}

void roughenCracks(CrackComplex& complex, const LabelLattice& lattice, double amplitude, std::uint64_t seed) {
    for (std::size_t p = 0; p < complex.origins.size(); ++p) {
        CrackPoint& origin = complex.origins[p];
        if (origin.nodes[0] < 0 || origin.fixed) continue;
        const double length = (lattice.nodes[origin.nodes[1]] - lattice.nodes[origin.nodes[0]]).norm();
        const double random = hashedRandom(seed, p, 3);
        // Scaled to the room there is, not cut off there: points would gather at the ends.
        const double room = random > 0 ? 1 - smallest_t - origin.t : origin.t - smallest_t;
        origin.t = clampToEdge(origin.t + random * std::min(room, amplitude / length));
    }
    placePoints(complex, lattice);
}

void nudgeTriangle(CrackComplex& complex, const LabelLattice& lattice, int triangle, std::uint64_t seed,
                   int attempt) {
    for (int p : complex.triangles[triangle]) nudgePoint(complex, p, seed, attempt);
    placePoints(complex, lattice);
}

void placePoints(CrackComplex& complex, const LabelLattice& lattice) {
    for (std::size_t p = 0; p < complex.points.size(); ++p)
        complex.points[p] = placeOf(complex, lattice, complex.origins[p]);
}

}  // namespace sherd
