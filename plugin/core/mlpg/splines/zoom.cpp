#include "core/mlpg/splines/zoom.h"

#include <algorithm>

#include "core/linear_algebra/conjugate_gradients.h"
#include "core/mlpg/pinned_unknowns.h"
#include "core/mlpg/splines/internal_forces.h"
#include "core/mlpg/splines/spline_motions.h"
#include "core/mlpg/splines/spline_refinement.h"
#include "core/mlpg/splines/spline_stiffness.h"
#include "core/sampling/cell_moments.h"

namespace sherd {
namespace {

constexpr int cells_of_rim =
    1;  // along the border of a box, which are not read: most functions there are held

/// Functions whose support reaches beyond the box: the correction must not.
std::vector<int> functionsAcrossBorder(const SplineSpace& space, const Eigen::Vector3i& lower,
                                       const Eigen::Vector3i& upper) {
    std::vector<int> held;
    for (int f = 0; f < space.function_count; ++f) {
        const Eigen::Vector3i& highest = space.highest_cells[f];
        const bool inside = ((highest.array() - space.degree) >= lower.array()).all() &&
                            (highest.array() < upper.array()).all();
        if (!inside) held.push_back(f);
    }
    return held;
}

/// The box in cells of the fine grid, which begin along x where the coarse grid or the box does, whichever
/// comes first.
CellBox onFineGrid(const CellBox& box) {
    const Eigen::Vector3i begin(2 * (box.lower.x() - std::min(0, box.lower.x())), 0, 0);
    return {begin, begin + 2 * (box.upper - box.lower)};
}

/// What must not move: functions that reach beyond the box, and where nothing of a component does and no
/// support holds it, six unknowns against its rigid motions.
std::vector<int> heldUnknowns(const CellParts& fine, const SplineSpace& space, const CellBox& fine_box,
                              const std::vector<PointSpring>& springs, const SparseMatrix& stiffness) {
    std::vector<int> held;
    std::vector<char> is_held(space.component_count, 0);
    for (const PointSpring& spring : springs) is_held[space.component_of_part[spring.part]] = 1;
    for (const int function : functionsAcrossBorder(space, fine_box.lower, fine_box.upper)) {
        is_held[space.component[function]] = 1;
        for (int i = 0; i < 3; ++i) held.push_back(3 * function + i);
    }
    const RigidMotions motions = splineMotions(fine, space);
    for (const int unknown : unknownsToPin(motions, stiffness))
        if (!is_held[motions.componentOfUnknown(unknown)]) held.push_back(unknown);
    return held;
}

/// What is added to the coarse displacement, at the raw functions; `entries` counts the numbers stored for
/// it.
Result<Eigen::Matrix3Xd> solveCorrection(const SplineField& coarse, const CellBox& fine_box,
                                         const Elasticity& elasticity, const BodyLoads& loads,
                                         const std::vector<PointSpring>& springs,
                                         const VolumetricProjection* projection, long long& entries) {
    const CellParts& fine = *coarse.parts;
    const SplineSpace& space = *coarse.space;
    Eigen::Matrix3Xd external = bodyForcesAt(fine, space, loads.body_forces);
    addPointForces(fine, space, loads.forces, external);
    Eigen::VectorXd residual = space.gather(
        external - splineInternalForces(fine, space, elasticity, springs, projection, coarse.raw));
    SparseMatrix stiffness = splineStiffness(fine, space, elasticity, springs, projection);
    const std::vector<int> held = heldUnknowns(fine, space, fine_box, springs, stiffness);
    pinUnknowns(stiffness, held);
    for (const int unknown : held) residual[unknown] = 0;
    entries = static_cast<long long>(stiffness.values.size());
    constexpr double tolerance = 1e-5;  // far below what the grid resolves
    const Result<Eigen::VectorXd> correction = solveByConjugateGradients(stiffness, residual, tolerance);
    if (!correction) return Error{correction.error()};
    return space.expand(correction.value());
}

}  // namespace

Result<Zoom> zoomIn(const TriangleMesh& surface, const SplineField& coarse, const CellBox& box,
                    const Elasticity& elasticity, const BodyLoads& loads,
                    const std::vector<SupportSpring>& supports) {
    Result<CellParts> refined = refineCellParts(surface, *coarse.parts, box.lower, box.upper);
    if (!refined) return Error{refined.error()};
    Zoom zoom;
    SplineField& field = zoom.field;
    field.parts = std::make_shared<const CellParts>(std::move(refined).value());
    const CellParts& fine = *field.parts;
    field.space = std::make_shared<const SplineSpace>(fine, coarse.space->degree);
    const std::vector<int> parents = parentParts(*coarse.parts, fine);
    field.raw = refinedCoefficients(*coarse.parts, *coarse.space, coarse.raw, fine, *field.space, parents);
    zoom.loads = loadsInside(fine, *field.space, parents, loads);

    const auto projection = projectionFor(elasticity, fine, *field.space);
    const CellBox fine_box = onFineGrid(box);
    const Result<Eigen::Matrix3Xd> correction =
        solveCorrection(field, fine_box, elasticity, zoom.loads, springsOf(fine, supports), projection.get(),
                        zoom.stiffness_entries);
    if (!correction) return Error{correction.error()};
    field =
        splineField(field.parts, field.space, field.raw + correction.value(), elasticity, projection.get());
    const Eigen::Vector3i rim = Eigen::Vector3i::Constant(cells_of_rim);
    zoom.inner = {fine_box.lower + rim, fine_box.upper - rim};
    return zoom;
}

bool displacementGradient(const Zoom& zoom, const Vec3& x, Mat3& gradient) {
    const CellParts& grid = *zoom.field.parts;
    const Eigen::Array3d u = (x - grid.origin).cwiseQuotient(grid.edges);
    const bool inside = (u >= zoom.inner.lower.cast<double>().array()).all() &&
                        (u < zoom.inner.upper.cast<double>().array()).all();
    const GridPoint point = inside ? locate(grid, x) : GridPoint{};
    if (point.part < 0) return false;
    gradient = gradientOn(zoom.field, point.part, point.xi);
    return true;
}

}  // namespace sherd
