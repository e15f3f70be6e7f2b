#pragma once

#include <sherd/result.h>
#include <sherd/settings.h>
#include <sherd/triangle_mesh.h>

#include "core/sampling/discretisation.h"
#include "core/sampling/moment_rule.h"

namespace sherd {

/// Samples the inside of a closed surface: a grid of particles at `spacing_m`, their sub-domains cut exactly
/// by the surface. Parts of one grid cell that are not connected inside it become particles of their own, so
/// that neighbours meet only through the solid; a gap narrower than an integration cell (spacing /
/// cells_per_spacing) may be bridged. `smallest_fill`: a part that fills less of its grid cell joins the part
/// it hangs on, unless it is a piece of a sheet or a rod that is thin everywhere. Particles are in ascending
/// order of their grid cells (z, y, x); no part of the solid is lost. Fails with a sentence if the grid would
/// be too large or the surface is not closed.
Result<Discretisation> sampleSolid(const TriangleMesh& surface, double spacing_m,
                                   const SamplingSettings& settings, MomentRule rule = MomentRule::exact);

/// The parts of the grid's cells alone, with moments up to `order`: all that a solve on splines needs, if
/// nobody asks for its stress.
Result<CellParts> sampleParts(const TriangleMesh& surface, double spacing_m, int cells_per_spacing, int order,
                              MomentRule rule);

}  // namespace sherd
