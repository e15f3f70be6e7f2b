#pragma once

#include <sherd/result.h>
#include <sherd/triangle_mesh.h>

namespace sherd {

/// A closed surface around a mesh that may be open, crossing or in pieces (CGAL's alpha wrapping; Portaneri
/// et al. 2022). It passes the mesh at a distance of `offset`, and enters what is wider than `alpha`, both m.
TriangleMesh wrapped(const TriangleMesh& mesh, double alpha, double offset);

/// The surface of the cavity that leaves walls of `thickness` (m) in a solid, facing into the cavity; empty
/// if the solid is nowhere thick enough. `alpha` (m) is about the size of its triangles.
TriangleMesh cavityOf(const TriangleMesh& solid, double thickness, double alpha);

}  // namespace sherd
