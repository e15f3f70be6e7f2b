#pragma once

#include <sherd/result.h>
#include <sherd/triangle_mesh.h>

namespace sherd {

/// Closed, oriented outward, finite, not empty, not self-intersecting, of one or more parts (CGAL), with
/// as many attributes as triangles or vertices. The error names each kind of fault with its count, the first
/// triangles (by the faces of the file, if the mesh knows them), where in space, and what to do. Crossings
/// are looked for in manifolds only.
Status checkSurface(const TriangleMesh& mesh);

/// The part of it without which nothing else can be looked at: there are triangles, of vertices that there
/// are, at finite places, with as many attributes as they need.
Status checkNumbers(const TriangleMesh& mesh);

/// A small percentile of the wall thickness seen by rays shot inward from the triangles, m; 0 if no ray meets
/// a wall.
double wallThickness(const TriangleMesh& mesh);

}  // namespace sherd
