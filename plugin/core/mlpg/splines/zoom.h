#pragma once

#include <sherd/result.h>
#include <sherd/triangle_mesh.h>

#include <memory>

#include "core/mlpg/splines/spline_space.h"
#include "core/mlpg/splines/spline_stiffness.h"

namespace sherd {

/// A displacement in splines on the parts of a solid.
struct SplineField {
    std::shared_ptr<const CellParts> parts;
    std::shared_ptr<const SplineSpace> space;
    Eigen::Matrix3Xd raw;  ///< coefficients of all functions, 3 x raw_count, m
};

/// Displacement gradient of a field on a part, `xi` in its cell, edges from the middle.
Mat3 gradientOn(const SplineField& field, int part, const Vec3& xi);

/// A point in a solid's grid: found once, read after every solve.
struct GridPoint {
    int part = -1;           ///< nearest to the point; -1: none is near
    Vec3 xi = Vec3::Zero();  ///< in the part's cell, edges from its middle
};
GridPoint locate(const CellParts& solid, const Vec3& x);

/// A body force that is an affine function of place, N/m^3: value + gradient (x - about).
struct AffineForce {
    Vec3 value = Vec3::Zero();
    Mat3 gradient = Mat3::Zero();
    Vec3 about = Vec3::Zero();
};

/// Everything that acts on a body.
struct BodyLoads {
    std::vector<PointForce> forces;
    std::vector<AffineForce> body_forces;  ///< per part of the grid that they are given for
};

/// A box of cells of a grid, `upper` exclusive; it may reach beyond the grid.
struct CellBox {
    Eigen::Vector3i lower, upper;
};

/// Boxes around those loads that act on a patch of fewer than four cells across: there stress diverges as the
/// grid gets finer, and the coarse grid only sees the resultant. Patches above `largest_patch` (m) are left
/// alone. At least `margin` cells beyond the loads.
std::vector<CellBox> boxesAroundLoads(const CellParts& grid, const std::vector<PointForce>& loads,
                                      double largest_patch, double margin);

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
