#include "core/mlpg/splines/zoom.h"

#include <algorithm>

#include "core/linear_algebra/block_product.h"
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

/// Functions whose support does not reach beyond the box: the correction must not.
std::vector<int> functionsInside(const SplineSpace& space, const CellBox& box) {
    std::vector<int> inside;
    for (int f = 0; f < space.function_count; ++f) {
        const Eigen::Vector3i& highest = space.highest_cells[f];
        if (((highest.array() - space.degree) >= box.lower.array()).all() &&
            (highest.array() < box.upper.array()).all())
            inside.push_back(f);
    }
    return inside;
}

/// The box in cells of the fine grid, which begin along x where the coarse grid or the box does, whichever
/// comes first.
CellBox onFineGrid(const CellBox& box) {
    const Eigen::Vector3i begin(2 * (box.lower.x() - std::min(0, box.lower.x())), 0, 0);
    return {begin, begin + 2 * (box.upper - box.lower)};
}

/// The rows and columns of some functions, which ascend.
BlockMatrix blocksAmong(const std::vector<int>& functions, const BlockMatrix& matrix) {
    std::vector<int> place(matrix.blockColumns(), -1);
    for (size_t f = 0; f < functions.size(); ++f) place[functions[f]] = static_cast<int>(f);
    BlockMatrix part;
    std::vector<int> rows;
    for (const int function : functions) {
        rows.clear();
        for (int k = matrix.starts[function]; k < matrix.starts[function + 1]; ++k)
            if (const int row = place[matrix.rows[k]]; row >= 0) rows.push_back(row);
        part.addColumn(rows);
        for (int j = 0; j < 3; ++j) {
            const double* value = matrix.column(function, j);
            for (int k = matrix.starts[function]; k < matrix.starts[function + 1]; ++k, value += 3)
                if (place[matrix.rows[k]] >= 0) part.values.insert(part.values.end(), value, value + 3);
        }
    }
    return part;
}

/// Where all of a component moves and no support holds it, six unknowns against its rigid motions; as
/// unknowns of the moving functions.
std::vector<int> heldUnknowns(const CellParts& fine, const SplineSpace& space, const std::vector<int>& moving,
                              const std::vector<PointSpring>& springs, const BlockMatrix& stiffness) {
    std::vector<int> place(space.function_count, -1);
    for (size_t f = 0; f < moving.size(); ++f) place[moving[f]] = static_cast<int>(f);
    std::vector<char> is_held(space.component_count, 0);
    for (const PointSpring& spring : springs) is_held[space.component_of_part[spring.part]] = 1;
    for (int f = 0; f < space.function_count; ++f)
        if (place[f] < 0) is_held[space.component[f]] = 1;
    std::vector<int> held;
    if (std::all_of(is_held.begin(), is_held.end(), [](char h) { return h; })) return held;
    const RigidMotions motions = splineMotions(fine, space);
    for (const int unknown : unknownsToPin(motions, stiffness))
        if (!is_held[motions.componentOfUnknown(unknown)])
            held.push_back(3 * place[unknown / 3] + unknown % 3);
    return held;
}

/// K c = r for what moves.
Result<Eigen::VectorXd> solveCorrection(const ZoomGrid& grid, const Eigen::VectorXd& residual) {
    constexpr double tolerance = 1e-5;  // far below what the grid resolves
    if (!grid.factor) return solveByConjugateGradients(grid.stiffness, residual, tolerance);
    const auto residual_of = [&](const Eigen::VectorXd& unknowns) -> Eigen::VectorXd {
        return residual - blockProduct(grid.stiffness, unknowns);
    };
    Result<PinnedSystem::Solution> solved = grid.factor->solve(residual, residual_of, tolerance);
    if (!solved) return Error{solved.error()};
    return std::move(solved.value().unknowns);
}

}  // namespace

long long ZoomGrid::entries() const {
    return static_cast<long long>(stiffness.values.size()) + (factor ? factor->solver().factorEntries() : 0);
}

Result<ZoomGrid> zoomGrid(const TriangleMesh& surface, const CellParts& coarse, const SplineSpace& space,
                          const CellBox& box, const Elasticity& elasticity,
                          const std::vector<SupportSpring>& supports) {
    Result<CellParts> refined = refineCellParts(surface, coarse, box.lower, box.upper);
    if (!refined) return Error{refined.error()};
    ZoomGrid grid;
    grid.parts = std::make_shared<const CellParts>(std::move(refined).value());
    grid.space = std::make_shared<const SplineSpace>(*grid.parts, space.degree);
    grid.parents = parentParts(coarse, *grid.parts);
    grid.springs = springsOf(*grid.parts, supports);
    grid.projection = projectionFor(elasticity, *grid.parts, *grid.space);
    grid.box = onFineGrid(box);
    const Eigen::Vector3i rim = Eigen::Vector3i::Constant(cells_of_rim);
    grid.inner = {grid.box.lower + rim, grid.box.upper - rim};
    const BlockMatrix stiffness =
        splineStiffness(*grid.parts, *grid.space, elasticity, grid.springs, grid.projection.get());
    grid.moving = functionsInside(*grid.space, grid.box);
    grid.held = heldUnknowns(*grid.parts, *grid.space, grid.moving, grid.springs, stiffness);
    grid.stiffness = blocksAmong(grid.moving, stiffness);
    pinUnknowns(grid.stiffness, grid.held);
    return grid;
}

Status factorZoom(ZoomGrid& grid) {
    std::vector<Eigen::Vector3i> places;
    for (const int function : grid.moving) places.push_back(grid.space->highest_cells[function]);
    Result<PinnedSystem> system = PinnedSystem::factor(grid.stiffness, grid.held, places, Precision::refined);
    if (!system) return Error{system.error()};
    grid.factor = std::make_shared<const PinnedSystem>(std::move(system).value());
    return success();
}

Result<Zoom> zoomIn(const ZoomGrid& grid, const SplineField& coarse, const Elasticity& elasticity,
                    const BodyLoads& loads) {
    const CellParts& fine = *grid.parts;
    const SplineSpace& space = *grid.space;
    const Eigen::Matrix3Xd raw =
        refinedCoefficients(*coarse.parts, *coarse.space, coarse.raw, fine, space, grid.parents);
    Zoom zoom;
    zoom.loads = loadsInside(fine, space, grid.parents, loads);
    zoom.inner = grid.inner;
    zoom.stiffness_entries = grid.entries();
    Eigen::Matrix3Xd external = bodyForcesAt(fine, space, zoom.loads.body_forces);
    addPointForces(fine, space, zoom.loads.forces, external);
    const Eigen::VectorXd all = space.gather(
        external - splineInternalForces(fine, space, elasticity, grid.springs, grid.projection.get(), raw));
    Eigen::VectorXd residual(grid.stiffness.size());
    for (size_t f = 0; f < grid.moving.size(); ++f)
        residual.segment<3>(3L * f) = all.segment<3>(3L * grid.moving[f]);
    for (const int unknown : grid.held) residual[unknown] = 0;
    const Result<Eigen::VectorXd> solved = solveCorrection(grid, residual);
    if (!solved) return Error{solved.error()};
    Eigen::VectorXd correction = Eigen::VectorXd::Zero(all.size());
    for (size_t f = 0; f < grid.moving.size(); ++f)
        correction.segment<3>(3L * grid.moving[f]) = solved.value().segment<3>(3L * f);
    zoom.field = splineField(grid.parts, grid.space, raw + space.expand(correction), elasticity,
                             grid.projection.get());
    return zoom;
}

bool isInside(const Zoom& zoom, const Vec3& x) {
    const CellParts& grid = *zoom.field.parts;
    const Eigen::Array3d u = (x - grid.origin).cwiseQuotient(grid.edges);
    return (u >= zoom.inner.lower.cast<double>().array()).all() &&
           (u < zoom.inner.upper.cast<double>().array()).all();
}

bool displacementGradient(const Zoom& zoom, const Vec3& x, Mat3& gradient) {
    const GridPoint point = isInside(zoom, x) ? locate(*zoom.field.parts, x) : GridPoint{};
    if (point.part < 0) return false;
    gradient = gradientOn(zoom.field, point.part, point.xi);
    return true;
}

}  // namespace sherd
