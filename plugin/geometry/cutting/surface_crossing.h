#pragma once

#include <sherd/triangle_mesh.h>

#include <vector>

#include "geometry/cutting/crack_complex.h"

namespace sherd {

/// Where an edge of one surface goes through a triangle of the other.
struct EdgeCrossing {
    int edge;   ///< in the edge table of the surface that the edge belongs to
    double t;   ///< place on the edge, from its lower vertex
    int point;  ///< in `SurfaceCrossing::points`
    int crack_triangle;
};

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
    std::vector<EdgeCrossing> on_body_edges, on_crack_edges;  ///< by edge and place
    std::vector<CutSegment> segments;                         ///< by body triangle
    std::vector<int> degenerate;  ///< crack triangles that touch a vertex or an edge, or nearly so
};

SurfaceCrossing crossSurfaces(const TriangleMesh& body, const EdgeTable& body_edges,
                              const CrackComplex& crack, const EdgeTable& crack_edges);

}  // namespace sherd
