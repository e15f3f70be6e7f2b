#pragma once

#include "core/mlpg/splines/zoom.h"

namespace sherd {

/// How often, and how far around the loads, the grid is made finer.
struct Resampling {
    int rounds = 0;
    double margin = 0;  ///< beyond the loads, in cells of the coarser grid, at least
};

/// Finer and finer grids around the loads of a solved displacement, coarser ones first. `surface` bounds the
/// body.
Result<std::vector<Zoom>> resample(const TriangleMesh& surface, const SplineField& whole,
                                   const BodyLoads& loads, const Elasticity& elasticity,
                                   const std::vector<SupportSpring>& supports, const Resampling& resampling);

}  // namespace sherd
