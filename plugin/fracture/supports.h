#pragma once

#include <sherd/result.h>
#include <sherd/surface_region.h>
#include <sherd/triangle_mesh.h>

#include <vector>

#include "core/mlpg/stress_solver.h"

namespace sherd {

/// Quadrature points, about `spacing_m` apart or closer where a part is narrow, of the parts of the surface
/// that regions take. Crack faces are held by nothing. The error says which region touches no surface.
Result<std::vector<SupportPoint>> pointsOfSupports(const TriangleMesh& surface,
                                                   const std::vector<SurfaceRegion>& regions,
                                                   double spacing_m);

/// The region that holds all of a surface by itself, so that nothing could come loose; nullptr if there is
/// none. `points`: those of the regions.
const SurfaceRegion* supportThatHoldsAll(const TriangleMesh& surface,
                                         const std::vector<SurfaceRegion>& regions,
                                         const std::vector<SupportPoint>& points);

/// Those regions that hold a piece of a broken body; none if together they leave it free to turn.
/// `spacing_m`: between its particles; regions that touch less than a particle's face hold nothing.
std::vector<SurfaceRegion> supportsThatHold(const TriangleMesh& piece,
                                            const std::vector<SurfaceRegion>& regions, double spacing_m,
                                            double wall_thickness_m);

}  // namespace sherd
