#pragma once

#include <array>
#include <vector>

#include "geometry/cutting/edge_table.h"
#include "geometry/cutting/label_lattice.h"

namespace sherd {

/// A point of the crack faces: on a lattice edge where two labels meet; on a lattice face where three meet,
/// between the points on its edges; or inside a tetrahedron where four meet, between the points on its faces.
struct CrackPoint {
    int nodes[2] = {-1, -1};                        ///< ends of the lattice edge, for a point on one
    double t = 0.5;                                 ///< place on that edge, from nodes[0] to nodes[1]
    std::array<int, 4> between = {-1, -1, -1, -1};  ///< else: three or four points of lower index
    std::array<double, 4> weights = {0.25, 0.25, 0.25, 0.25};  ///< theirs, positive with sum 1
    bool fixed = false;                                        ///< not to be smoothed or roughened

    bool isOnEdge() const { return nodes[0] >= 0; }
    bool isInTetrahedron() const { return between[3] >= 0; }
};

/// The faces between labels, as one conforming complex of triangles (not a manifold: three fragments meet at
/// a line, four at a point). Every label's region is bounded by a manifold. The normal of a triangle points
/// from below to above.
struct CrackComplex {
    struct Sides {
        int below, above;  ///< labels
    };
    std::vector<CrackPoint> origins;  ///< #points, where on the lattice each is
    std::vector<Vec3> points;         ///< m
    std::vector<Triangle> triangles;
    std::vector<Sides> sides;        ///< #triangles
    std::vector<int> first_of_cell;  ///< #active cells + 1, offsets: the triangles made in each
    /// #triangles, unit normals that they had before they were roughened; empty: they are smooth.
    std::vector<Vec3> smooth_normals;
};

/// The nearest place on an edge that a point may have. Points keep at least `least` from both ends, as a
/// fraction of the edge: so there are no slivers, and no piece of a label is thinner.
double clampToEdge(double t, double least);

/// The position of a point, m; the points it lies between must have theirs.
Vec3 positionOf(const CrackPoint& point, const CrackComplex& complex, const LabelLattice& lattice);

/// Sets the weights of a point on a lattice face so that it is as near to `wanted` as it can be with weights
/// of at least `least`. Weights stay positive so that the point stays inside the triangle of the points on
/// the face's edges: there the sheets of one tetrahedron cannot cross.
void placeInFace(CrackPoint& point, const CrackComplex& complex, const Vec3& wanted, double least);

/// Recomputes all positions from the places on edges and the weights.
void placePoints(CrackComplex& complex, const LabelLattice& lattice);

}  // namespace sherd
