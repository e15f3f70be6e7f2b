#pragma once

#include <sherd/result.h>
#include <sherd/settings.h>
#include <sherd/triangle_mesh.h>

namespace sherd {

/// Particle spacing of a solid, m: the one given, or what the wall thickness and the limits on counts ask
/// for, made coarser until the factor of the stiffness matrix is as small as the settings wish.
Result<double> spacingOfSolid(const TriangleMesh& surface, const Settings& settings, double volume_m3,
                              double wall_thickness_m);

/// Of a fragment: as coarse as the sampling has it, or finer where that would leave it too few particles. A
/// sheet has those of one layer.
double fragmentSpacing(double spacing_of_whole_m, const SamplingSettings& sampling, double volume_m3,
                       double area_m2);

}  // namespace sherd
