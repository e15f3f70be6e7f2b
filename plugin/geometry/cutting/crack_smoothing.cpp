#include "geometry/cutting/crack_smoothing.h"

#include <algorithm>

namespace sherd {

namespace {

// Of each of the three points that a point on a face lies between, before the weights are scaled to sum 1.
constexpr double smallest_weight = 0.1;

// The points that are smoothed, and the triangles that have one.
struct Moving {
    std::vector<char> points;
    std::vector<int> triangles;
};

// Sums over the neighbours of every moving point. Of a point on a line where sheets meet only those on the
// line count.
struct NeighbourSums {
    std::vector<Vec3> position;
    std::vector<int> count;
};

NeighbourSums sumNeighbours(const CrackComplex& complex, const Moving& moving) {
    NeighbourSums sums = {std::vector<Vec3>(complex.points.size(), Vec3::Zero()),
                          std::vector<int>(complex.points.size(), 0)};
    const auto is_on_line = [&](int p) { return !complex.origins[p].isOnEdge(); };
    for (const int triangle : moving.triangles) {
        const Triangle& t = complex.triangles[triangle];
        for (int i = 0; i < 3; ++i) {
            if (!moving.points[t[i]]) continue;
            for (int other : {t[(i + 1) % 3], t[(i + 2) % 3]}) {
                if (is_on_line(t[i]) && !is_on_line(other)) continue;
                sums.position[t[i]] += complex.points[other];
                ++sums.count[t[i]];
            }
        }
    }
    return sums;
}

double placeOnEdge(const CrackPoint& origin, const LabelLattice& lattice, const Vec3& wanted) {
    const Vec3 a = lattice.nodes[origin.nodes[0]], edge = lattice.nodes[origin.nodes[1]] - a;
    return clampToEdge((wanted - a).dot(edge) / edge.squaredNorm(), lattice.smallest_edge_place);
}

// Whether a point lies between two labels whose crack the particles' shares place already.
bool isSharp(const CrackPoint& point, const LabelLattice& lattice) {
    return point.isOnEdge() && lattice.isSharp(point.nodes[0]) && lattice.isSharp(point.nodes[1]);
}

// Sharp points move only `with_sharp`, points inside tetrahedra never.
Moving findMoving(const CrackComplex& complex, const LabelLattice& lattice, bool with_sharp) {
    Moving moving;
    for (const CrackPoint& origin : complex.origins)
        moving.points.push_back(!origin.isInTetrahedron() && !origin.fixed &&
                                (with_sharp || !isSharp(origin, lattice)));
    for (std::size_t t = 0; t < complex.triangles.size(); ++t) {
        const auto& [a, b, c] = complex.triangles[t];
        if (moving.points[a] || moving.points[b] || moving.points[c])
            moving.triangles.push_back(static_cast<int>(t));
    }
    return moving;
}

// Moves points half the way toward the mean of their neighbours, within the edge or face that they belong to.
void smoothOnce(CrackComplex& complex, const LabelLattice& lattice, const Moving& moving) {
    const NeighbourSums sums = sumNeighbours(complex, moving);
    for (std::size_t p = 0; p < complex.points.size(); ++p) {
        CrackPoint& origin = complex.origins[p];
        if (!moving.points[p] || sums.count[p] == 0) continue;
        const Vec3 wanted = 0.5 * (complex.points[p] + sums.position[p] / sums.count[p]);
        if (origin.isOnEdge())
            origin.t = placeOnEdge(origin, lattice, wanted);
        else
            placeInFace(origin, complex, wanted, smallest_weight);
    }
    placePoints(complex, lattice);
}

}  // namespace

void smoothCracks(CrackComplex& complex, const LabelLattice& lattice, int steps) {
    if (steps < 1 || lattice.cracks) return;
    smoothOnce(complex, lattice, findMoving(complex, lattice, true));
    const Moving moving = findMoving(complex, lattice, false);
    for (int step = 1; step < steps; ++step) smoothOnce(complex, lattice, moving);
}

}  // namespace sherd
