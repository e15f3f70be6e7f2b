#pragma once

#include <sherd/repair.h>

namespace sherd {

/// Of a vessel: diagonal of its rim, over that of the mesh.
constexpr double smallest_opening = 0.15;

// Each takes and gives a manifold with or without borders (CGAL's polygon mesh processing).

/// Flips or collapses triangles without area.
void removeFlat(TriangleMesh& mesh, RepairReport& report);

/// Closes borders with triangles, and gives those alone. Holes of more than 4000 edges or `largest_m` across
/// stay open, and so does a rim that goes around the whole mesh and a large area: that is a sheet, whose
/// other side is not there.
TriangleMesh fillHoles(TriangleMesh& mesh, double largest_m, RepairReport& report);

/// Undoes crossings within one part, if they are few: cuts out what crosses, with some triangles around it,
/// and fills the hole. Leaves them where that would move the surface by more than a hundredth of its size.
void undoCrossings(TriangleMesh& mesh, RepairReport& report);

/// Turns parts outward that face inward, leaves out those without volume, and unites those that overlap or
/// lie inside others; a part inside another that faces inward is a cavity and stays. All must be closed.
Status uniteParts(TriangleMesh& mesh, RepairReport& report);

}  // namespace sherd
