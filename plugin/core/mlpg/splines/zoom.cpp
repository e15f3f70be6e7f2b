#include "core/mlpg/splines/zoom.h"

#include <algorithm>
#include <map>

#include "core/linear_algebra/conjugate_gradients.h"
#include "core/mlpg/particle_forms/galerkin_stiffness.h"
#include "core/mlpg/rigid_motions.h"
#include "core/mlpg/splines/spline_refinement.h"
#include "core/sampling/cell_moments.h"

namespace sherd {
namespace {

constexpr int cells_across_patch = 4;  // that a grid needs to see how a load is spread
constexpr int cells_of_rim = 1;        // along the border of a box, with too few functions left that may move

struct PatchBounds {
    Vec3 lower, upper;
};

/// Loads that act in the same or in touching cells belong to one patch.
std::vector<PatchBounds> loadPatches(const CellParts& grid, const std::vector<PointForce>& loads) {
    std::map<std::array<int, 3>, std::pair<int, PatchBounds>>
        cells;  // patch and bounds of the loads in a cell
    for (const PointForce& load : loads) {
        const Vec3 u = (load.position - grid.origin).cwiseQuotient(grid.edges);
        const Eigen::Vector3i cell = u.array().floor().cast<int>();
        const auto [place, fresh] = cells.try_emplace({cell.z(), cell.y(), cell.x()}, -1, PatchBounds{u, u});
        PatchBounds& bounds = place->second.second;
        bounds.lower = bounds.lower.cwiseMin(u);
        bounds.upper = bounds.upper.cwiseMax(u);
    }
    std::vector<PatchBounds> patches;
    for (auto& [start, entry] : cells) {
        if (entry.first >= 0) continue;
        entry.first = static_cast<int>(patches.size());
        patches.push_back(entry.second);
        std::vector<std::array<int, 3>> queue{start};
        while (!queue.empty()) {
            const std::array<int, 3> cell = queue.back();
            queue.pop_back();
            for (int n = 0; n < 27; ++n) {
                const auto other =
                    cells.find({cell[0] + n / 9 - 1, cell[1] + n / 3 % 3 - 1, cell[2] + n % 3 - 1});
                if (other == cells.end() || other->second.first >= 0) continue;
                other->second.first = entry.first;
                PatchBounds& sum = patches.back();
                sum.lower = sum.lower.cwiseMin(other->second.second.lower);
                sum.upper = sum.upper.cwiseMax(other->second.second.upper);
                queue.push_back(other->first);
            }
        }
    }
    return patches;
}

bool overlap(const CellBox& a, const CellBox& b) {
    return (a.lower.array() < b.upper.array()).all() && (b.lower.array() < a.upper.array()).all();
}

/// Functions whose support reaches beyond the box: the correction must not.
std::vector<int> functionsAcrossBorder(const SplineSpace& space, const Eigen::Vector3i& lower,
                                       const Eigen::Vector3i& upper) {
    std::vector<int> held;
    for (int f = 0; f < space.function_count; ++f) {
        const Eigen::Vector3i& highest = space.points[f];
        const bool inside = ((highest.array() - space.degree) >= lower.array()).all() &&
                            (highest.array() < upper.array()).all();
        if (!inside) held.push_back(f);
    }
    return held;
}

/// Forces of loads and body forces at the raw functions.
Eigen::Matrix3Xd externalForces(const SplineField& field, const BodyLoads& loads) {
    const CellParts& parts = *field.parts;
    const SplineSpace& space = *field.space;
    std::vector<Vec3> origins;
    for (const AffineForce& force : loads.body_forces) origins.push_back(force.about);
    Eigen::Matrix3Xd raw = Eigen::Matrix3Xd::Zero(3, space.raw_count);
    const Eigen::Matrix4Xd body = splineBodyMoments(parts, space, origins);
    for (size_t p = 0; p < parts.parts.size(); ++p)
        for (const int f : space.raw_of[p])  // all parts of a function are of one body, under one force
            raw.col(f) = loads.body_forces[p].value * body(0, f) +
                         loads.body_forces[p].gradient * body.col(f).tail<3>();
    std::vector<double> values;
    for (const PointForce& load : loads.forces) {
        const int part = parts.partAt(load.position);
        if (part < 0) continue;
        splineValues(space.degree, parts.toCell(load.position, parts.parts[part].cell), values);
        for (size_t a = 0; a < values.size(); ++a) raw.col(space.raw_of[part][a]) += values[a] * load.force;
    }
    return raw;
}

BodyLoads loadsInside(const CellParts& fine, const std::vector<int>& parents, const BodyLoads& loads) {
    BodyLoads inside;
    for (const PointForce& load : loads.forces)
        if (fine.partAt(load.position) >= 0) inside.forces.push_back(load);
    for (const int parent : parents)
        inside.body_forces.push_back(parent < 0 ? AffineForce{} : loads.body_forces[parent]);
    return inside;
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
                              const std::vector<PointSpring>& springs) {
    std::vector<int> held;
    std::vector<char> is_held(space.component_count, 0);
    for (const PointSpring& spring : springs) is_held[space.component_of_part[spring.part]] = 1;
    for (const int function : functionsAcrossBorder(space, fine_box.lower, fine_box.upper)) {
        is_held[space.component[function]] = 1;
        for (int i = 0; i < 3; ++i) held.push_back(3 * function + i);
    }
    const RigidMotions motions(fine, space);
    for (const int unknown : unknownsToPin(motions))
        if (!is_held[motions.componentOfUnknown(unknown)]) held.push_back(unknown);
    return held;
}

}  // namespace

std::vector<CellBox> boxesAroundLoads(const CellParts& grid, const std::vector<PointForce>& loads,
                                      double largest_patch, double margin) {
    std::vector<CellBox> boxes;
    for (const PatchBounds& patch : loadPatches(grid, loads)) {
        const Vec3 extent = patch.upper - patch.lower;
        if (extent.maxCoeff() >= cells_across_patch || extent.cwiseProduct(grid.edges).norm() > largest_patch)
            continue;
        const Vec3 border = Vec3::Constant(margin);
        boxes.push_back({(patch.lower - border).array().floor().cast<int>(),
                         (patch.upper + border).array().ceil().cast<int>()});
    }
    // Boxes that overlap would correct the same error twice.
    for (size_t i = 0; i < boxes.size(); ++i)
        for (size_t j = i + 1; j < boxes.size();) {
            if (!overlap(boxes[i], boxes[j])) {
                ++j;
                continue;
            }
            boxes[i] = {boxes[i].lower.cwiseMin(boxes[j].lower), boxes[i].upper.cwiseMax(boxes[j].upper)};
            boxes.erase(boxes.begin() + static_cast<long>(j));
            j = i + 1;
        }
    return boxes;
}

Result<Zoom> zoomIn(const TriangleMesh& surface, const SplineField& coarse, const CellBox& box,
                    const Elasticity& elasticity, const BodyLoads& loads,
                    const std::vector<SupportSpring>& supports) {
    Result<CellParts> refined = refineCellParts(surface, *coarse.parts, box.lower, box.upper);
    if (!refined) return Error{refined.error()};
    Zoom zoom;
    SplineField& field = zoom.field;
    field.parts = std::make_shared<const CellParts>(std::move(refined).value());
    const CellParts& fine = *field.parts;
    const auto space = std::make_shared<SplineSpace>(fine, coarse.space->degree);
    field.space = space;
    const std::vector<int> parents = parentParts(*coarse.parts, fine);
    field.raw = refinedCoefficients(*coarse.parts, *coarse.space, coarse.raw, fine, *space, parents);
    zoom.loads = loadsInside(fine, parents, loads);

    const std::vector<PointSpring> springs = springsOf(fine, supports);
    SparseMatrix stiffness = splineStiffness(fine, *space, elasticity, springs);
    Eigen::VectorXd residual =
        space->gather(externalForces(field, zoom.loads) -
                      splineInternalForces(fine, *space, elasticity, springs, field.raw));
    const CellBox fine_box = onFineGrid(box);
    const std::vector<int> held = heldUnknowns(fine, *space, fine_box, springs);
    pinUnknowns(stiffness, held);
    for (const int unknown : held) residual[unknown] = 0;

    constexpr double tolerance = 1e-5;  // far below what the grid resolves
    const Result<Eigen::VectorXd> correction = solveByConjugateGradients(stiffness, residual, tolerance);
    if (!correction) return Error{correction.error()};
    field.raw += space->expand(correction.value());
    const Eigen::Vector3i rim = Eigen::Vector3i::Constant(cells_of_rim);
    zoom.inner = {fine_box.lower + rim, fine_box.upper - rim};
    zoom.stiffness_entries = static_cast<long long>(stiffness.values.size());
    return zoom;
}

Mat3 gradientOn(const SplineField& field, int part, const Vec3& xi) {
    thread_local std::vector<Vec3> gradients;
    splineGradients(field.space->degree, xi, gradients);
    Mat3 gradient = Mat3::Zero();
    const std::vector<int>& functions = field.space->raw_of[part];
    for (size_t a = 0; a < functions.size(); ++a)
        gradient += field.raw.col(functions[a]) * gradients[a].transpose();
    return gradient * field.parts->edges.cwiseInverse().asDiagonal();
}

GridPoint locate(const CellParts& solid, const Vec3& x) {
    const int part = solid.partAt(x);
    if (part < 0) return {};
    return {part, solid.toCell(x, solid.parts[part].cell)};
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
