#pragma once

#include <sherd/triangle_mesh.h>

#include <vector>

#include "geometry/cutting/crack_complex.h"
#include "geometry/cutting/cuttable_surface.h"
#include "geometry/cutting/edge_crossings.h"

namespace sherd {

/// The line in which a body triangle and a crack triangle cross, directed along (body normal) x (crack
/// normal): in the body triangle the label below the crack lies on its left, in the crack triangle the
/// outside of the body.
struct CutSegment {
    int source, target;  ///< points
    int body_triangle, crack_triangle;
};

/// Where the cracks cross a body's surface. All decisions are exact. Every crossing point is made once and
/// shared by all triangles that meet there.
struct SurfaceCrossing {
    std::vector<Vec3> points;  ///< the body's vertices, then the crack's points, then the crossings, m
    int first_crack_point = 0;
    EdgeCrossings on_body_edges, on_crack_edges;
    std::vector<CutSegment> segments;  ///< by body triangle
    std::vector<int> degenerate;       ///< crack triangles that touch a vertex or an edge, or nearly so
};

/// The crack is the lattice's.
SurfaceCrossing crossSurfaces(const CuttableSurface& body, const LabelLattice& lattice,
                              const CrackComplex& crack, const EdgeTable& crack_edges);

}  // namespace sherd
