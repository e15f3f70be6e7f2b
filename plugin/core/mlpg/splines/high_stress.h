#pragma once

#include <sherd/triangle_mesh.h>

#include "core/mlpg/splines/load_boxes.h"
#include "core/mlpg/splines/spline_field.h"
#include "core/stress/elasticity.h"

namespace sherd {

/// A point of the surface where the error of a stress is estimated.
struct SurfaceSample {
    Vec3 position = Vec3::Zero();  ///< m
    Vec3 normal = Vec3::Zero();    ///< outward, of unit length
};

/// Samples of a body's surface: in every cube of half a cell of the grid, one for each direction that the
/// surface faces there.
std::vector<SurfaceSample> surfaceSamples(const TriangleMesh& surface, const CellParts& grid);

/// Stress of a displacement at a sample where nothing acts on the surface.
struct SampledStress {
    int sample = -1;
    double tension_pa = 0;  ///< the largest principal stress
    /// |sigma n|, which should be zero. Where a grid is too coarse for the stress it balances the traction
    /// over some cells only.
    double error_pa = 0;
};

/// Of those `samples` that lie in the field's grid.
std::vector<SampledStress> stressAtSamples(const SplineField& field, const Elasticity& elasticity,
                                           const std::vector<SurfaceSample>& all,
                                           const std::vector<int>& samples);

/// A cube of a grid's cells in which the stress is high and not known well.
struct HighStress {
    CellBox cells;
    double rank = 0;           ///< the largest tension times error, Pa^2
    std::vector<int> samples;  ///< in it
};

/// Cubes lie on a lattice that begins at cell 0, so that blows on one body share them. Left alone is what is
/// far below the largest tension in the body, `peak_pa`, and what is known well enough: to `error_share` of
/// it.
std::vector<HighStress> highStresses(const CellParts& grid, int cells_of_cube,
                                     const std::vector<SurfaceSample>& all,
                                     const std::vector<SampledStress>& stresses, double peak_pa,
                                     double error_share);

}  // namespace sherd
