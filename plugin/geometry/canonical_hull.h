#pragma once

#include "geometry/exact_union.h"

namespace sherd {

/// The one triangulation of a convex hull that follows from its points alone: without vertices inside of its
/// faces or edges, the others in the order of their coordinates, each face a fan about its first vertex.
/// CGAL's hulls have the same points, but it goes by addresses in memory where it has a choice.
ExactMesh canonicalHull(const ExactMesh& hull);

}  // namespace sherd
