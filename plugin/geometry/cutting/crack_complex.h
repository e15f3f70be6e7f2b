#pragma once

#include <vector>

#include "geometry/cutting/edge_table.h"
#include "geometry/cutting/label_lattice.h"

namespace sherd {

/// A point of the crack faces: on a lattice edge where two labels meet; on a lattice face where three meet,
/// between the points on its edges; or inside a tetrahedron where four meet, between the points on its faces.
struct CrackPoint {
    int nodes[2] = {-1, -1};                        ///< lattice edge, for a point on one
    double t = 0.5;                                 ///< place on that edge, from nodes[0] to nodes[1]
    std::array<int, 4> between = {-1, -1, -1, -1};  ///< earlier points, else: three, or four
    std::array<double, 4> weights = {0.25, 0.25, 0.25, 0.25};  ///< theirs, positive with sum 1
    bool fixed = false;                                        ///< not to be smoothed or roughened
};

/// The faces between labels, as one conforming complex of triangles (not a manifold: three fragments meet at
/// a line, four at a point). Every label's region is bounded by a manifold. The normal of a triangle points
/// from below to above.
struct CrackComplex {
    struct Sides {
        int below, above;  ///< labels
    };
    std::vector<CrackPoint> origins;  ///< #points
    std::vector<Vec3> points;         ///< m
    std::vector<Triangle> triangles;
    std::vector<Sides> sides;  ///< #triangles
};

constexpr int smoothing_steps = 6;

/// Marching tetrahedra for many materials, on the six tetrahedra of each active lattice cell (Freudenthal's
/// split). All points stay inside the tetrahedron, face or edge that they belong to, so the complex cannot
/// run through itself.
CrackComplex buildCrackComplex(const LabelLattice& lattice);

/// Moves every point half the way toward the mean of its neighbours, `steps` times, within its edge or face;
/// between two sharp labels once only.
void smoothCracks(CrackComplex& complex, const LabelLattice& lattice, int steps);

/// Moves the points along their lattice edges by up to `amplitude` m, at random, and no further than they may
/// go.
void roughenCracks(CrackComplex& complex, const LabelLattice& lattice, double amplitude, std::uint64_t seed);

/// Moves the points that the triangle depends on a little along their lattice edges; `attempt` gives another
/// place each time.
void nudgeTriangle(CrackComplex& complex, const LabelLattice& lattice, int triangle, std::uint64_t seed,
                   int attempt);

/// The place on an edge, kept as far from its ends as all points are.
double clampToEdge(double t);

/// Recomputes all positions from where the points are on their edges.
void placePoints(CrackComplex& complex, const LabelLattice& lattice);

}  // namespace sherd
