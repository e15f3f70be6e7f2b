#pragma once

#include <sherd/result.h>
#include <sherd/triangle_mesh.h>

#include "core/mlpg/pinned_system.h"
#include "core/mlpg/splines/load_boxes.h"
#include "core/mlpg/splines/spline_loads.h"
#include "core/mlpg/splines/spline_supports.h"
#include "core/mlpg/splines/volumetric_projection.h"

namespace sherd {

/// A finer grid of a part of a body, as it stays from blow to blow.
struct ZoomGrid {
    std::shared_ptr<const CellParts> parts;
    std::shared_ptr<const SplineSpace> space;
    std::vector<int> parents;  ///< see parentParts
    std::vector<PointSpring> springs;
    std::shared_ptr<const VolumetricProjection> projection;  ///< null: the material changes its volume
    CellBox box;                                             ///< that it fills, in cells of this grid
    CellBox inner;            ///< where it is better than the coarser one: not at the border
    std::vector<int> moving;  ///< functions inside the box, ascending: the correction is theirs
    std::vector<int> held;    ///< unknowns of these that hold what nothing else does
    BlockMatrix stiffness;    ///< of the moving functions
    std::shared_ptr<const PinnedSystem> factor;  ///< null: each solve is iterative

    long long entries() const;  ///< numbers stored for its solves
};

/// A displacement that is finer inside a box than elsewhere.
struct Zoom {
    SplineField field;
    BodyLoads loads;  ///< what acts on it
    CellBox inner;    ///< see ZoomGrid
    long long stiffness_entries = 0;
};

/// Whether a zoom is to be read at x.
bool isInside(const Zoom& zoom, const Vec3& x);

/// Displacement gradient of a zoom at x; false where the coarser grid is to be read.
bool displacementGradient(const Zoom& zoom, const Vec3& x, Mat3& gradient);

/// Cells half as long inside a box of a coarser grid's cells.
Result<ZoomGrid> zoomGrid(const TriangleMesh& surface, const CellParts& coarse, const SplineSpace& space,
                          const CellBox& box, const Elasticity& elasticity,
                          const std::vector<SupportSpring>& supports);

/// Factors the stiffness of a grid that more than one blow needs.
Status factorZoom(ZoomGrid& grid);

/// Resampling (paper, section 5) as a local zoom. The fine displacement is the coarse one plus a correction
/// that vanishes with its derivative at the border of the box,
///     a(correction, v) = f(v) - a(coarse, v) for all fine v inside the box,
/// so the coarse factorisation stays as it is. Nothing is handed back to the coarse grid: its far field
/// already knows the resultant of the loads, and further corrections in turn were measured to gain little.
Result<Zoom> zoomIn(const ZoomGrid& grid, const SplineField& coarse, const Elasticity& elasticity,
                    const BodyLoads& loads);

}  // namespace sherd
