#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <sherd/triangle_mesh.h>

#include <optional>

namespace sherd {

using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactMesh = CGAL::Surface_mesh<ExactKernel::Point_3>;

/// The union of two solids, by their closed surfaces, which do not cross themselves; nothing if it has an
/// edge or a point in which parts only touch. Nothing is rounded.
std::optional<ExactMesh> unionOf(ExactMesh a, ExactMesh b);

/// The mesh in double precision, with one vertex for each position; vertices and triangles in the order of
/// coordinates, for that of CGAL's unions goes by addresses in memory.
TriangleMesh roundedMesh(const ExactMesh& mesh);

}  // namespace sherd
