#pragma once

#include <sherd/result.h>
#include <sherd/settings.h>
#include <sherd/triangle_mesh.h>

#include "core/sampling/discretisation.h"

namespace sherd {

/// Samples the inside of a closed surface: a grid of particles at `spacing_m`, their sub-domains cut exactly by the
/// surface. Parts of one grid cell that are not connected inside it become particles of their own, so that neighbours
/// meet only through the solid. Fails with a sentence if the grid would be too large or the surface is not closed.
Result<Discretisation> sampleSolid(const TriangleMesh& surface, double spacing_m, const SamplingSettings& settings);

}  // namespace sherd
