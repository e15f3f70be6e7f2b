#pragma once

#include <sherd/result.h>
#include <sherd/triangle_mesh.h>

#include "core/mlpg/splines/load_boxes.h"
#include "core/mlpg/splines/spline_loads.h"
#include "core/mlpg/splines/spline_supports.h"

namespace sherd {

/// A finer grid around loads that the coarser one does not resolve.
struct Zoom {
    SplineField field;
    BodyLoads loads;  ///< what acts on it
    CellBox inner;    ///< cells of the field's grid where it is better than the coarser one: not those at the
                      ///< border
    long long stiffness_entries = 0;  ///< numbers stored for its solve, which needs no factor
};

/// Displacement gradient of a zoom at x; false where the coarser grid is to be read.
bool displacementGradient(const Zoom& zoom, const Vec3& x, Mat3& gradient);

/// Resampling (paper, section 5) as a local zoom: cells half as long inside the box. The fine displacement is
/// the coarse one plus a correction that vanishes with its derivative at the border of the box,
///     a(correction, v) = f(v) - a(coarse, v) for all fine v inside the box,
/// so the coarse factorisation stays as it is. Nothing is handed back to the coarse grid: its far field
/// already knows the resultant of the loads, and further corrections in turn were measured to gain little.
Result<Zoom> zoomIn(const TriangleMesh& surface, const SplineField& coarse, const CellBox& box,
                    const Elasticity& elasticity, const BodyLoads& loads,
                    const std::vector<SupportSpring>& supports);

}  // namespace sherd
