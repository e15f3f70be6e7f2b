#include <sherd/stress_model.h>

#include <algorithm>
#include <sstream>

#include "core/loads/surface_region.h"
#include "fracture/breakable_solid.h"
#include "geometry/surface_checks.h"
#include "geometry/surface_feet.h"
#include "stress_model/surface_tractions.h"

namespace sherd {

namespace {

template <class Item, class Read>
auto collected(const std::vector<Item>& items, const Read& read) {
    std::vector<std::decay_t<decltype(read(items.front()))>> values;
    values.reserve(items.size());
    for (const Item& item : items) values.push_back(read(item));
    return values;
}

std::string coarseForWalls(double spacing, double wall) {
    std::ostringstream text;
    text.precision(3);
    text << "The particle spacing of " << spacing << " m is larger than the thinnest walls, " << wall
         << " m: stress in them may be off by a third; use a higher quality or a smaller spacing.";
    return text.str();
}

/// Where the change that a traction makes at the surface has died away, in particle spacings: about as far as
/// the nearest points at which the gradients of quadratic splines are superconvergent.
constexpr double traction_depth = 0.25;

/// Feet on the surface of those points that lie within that depth, and whose feet have a normal.
struct ShallowPoints {
    std::vector<std::size_t> index;
    std::vector<SurfaceFoot> feet;
};

ShallowPoints shallowPoints(const BreakableSolid& body, const std::vector<SurfaceFoot>& feet) {
    const double depth = traction_depth * body.spacing();
    ShallowPoints shallow;
    for (std::size_t i = 0; i < feet.size(); ++i) {
        if (feet[i].distance > depth || feet[i].normal.isZero()) continue;
        shallow.index.push_back(i);
        shallow.feet.push_back(feet[i]);
    }
    return shallow;
}

/// Says how many points lie outside; empty if none does.
std::string outsideWarning(const BreakableSolid& body, const std::vector<SurfaceFoot>& feet) {
    constexpr double clearly = 0.05;  // of the spacing: facets run inside of round bodies
    long first = -1, count = 0;
    for (std::size_t i = 0; i < feet.size(); ++i) {
        if (!feet[i].outside || feet[i].distance < clearly * body.spacing()) continue;
        if (count++ == 0) first = static_cast<long>(i);
    }
    if (count == 0) return "";
    return std::to_string(count) + " of " + std::to_string(feet.size()) +
           " points lie outside the body, the first is number " + std::to_string(first) +
           " (from 0); stress there is zero or continued from inside. Are they in metres, in the body's "
           "frame?";
}

Status checkFinite(const std::vector<Vec3>& points, const Vec3& spin_rad_s) {
    if (!spin_rad_s.allFinite()) return Error{"The spin is not finite; give it in rad/s."};
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!points[i].allFinite())
            return Error{"Point number " + std::to_string(i) + " (from 0) is not finite."};
    return success();
}

/// Of a body whose solver is there.
const Discretisation& solidOf(const BreakableSolid& body) {
    return *body.discretisation().value();
}

}  // namespace

Result<StressModel> StressModel::make(const TriangleMesh& surface, const Material& material,
                                      const Settings& settings, const std::vector<SurfaceRegion>& supports,
                                      const Repair& repair) {
    Result<RepairedMesh> sound = repairMesh(surface, repair);
    if (!sound) return Error{sound.error()};
    Settings resampled = settings;
    resampled.stress.resample_contacts = true;
    auto body = BreakableSolid::make(std::move(sound.value().mesh), material, resampled, supports);
    if (!body) return Error{body.error()};
    if (const auto solver = body.value()->stressSolver(); !solver) return Error{solver.error()};
    return StressModel(std::move(body).value(), sound.value().report);
}

Result<StressField> StressModel::solve(const std::vector<SurfaceLoad>& loads, const std::vector<Vec3>& points,
                                       const Vec3& spin_rad_s) const {
    if (const Status finite = checkFinite(points, spin_rad_s); !finite) return Error{finite.error()};
    std::vector<PointForce> forces;
    std::vector<PlacedLoad> placed;
    for (const SurfaceLoad& load : loads) {
        const auto area = regionQuadrature(surface(), load.region, solid_->quadratureSpacing());
        if (!area) return Error{"A load cannot be placed: " + area.error()};
        const std::vector<PointForce> part = pointForces(load, area.value());
        forces.insert(forces.end(), part.begin(), part.end());
        placed.push_back({load, 0});
        for (const AreaPoint& point : area.value()) placed.back().area_m2 += point.area_m2;
    }
    const std::vector<SurfaceFoot> feet = surfaceFeet(surface(), points, edgeTolerance(*solid_));
    const ShallowPoints shallow = shallowPoints(*solid_, feet);
    std::vector<Vec3> asked = points;
    for (const SurfaceFoot& foot : shallow.feet) asked.push_back(foot.position);
    Result<StressField> result = solid_->stressSolver().value()->solve(forces, asked, spin_rad_s);
    if (!result) return result;

    StressField& field = result.value();
    const SurfaceTractions tractions(*solid_, placed);
    for (std::size_t i = 0; i < shallow.feet.size(); ++i) {
        const SurfaceFoot& foot = shallow.feet[i];
        const double depth = traction_depth * field.point_spacing_m[shallow.index[i]];
        if (foot.distance > depth) continue;
        const SymmetricTensor& raw = field.points[points.size() + i];
        field.points[shallow.index[i]] +=
            (1 - foot.distance / depth) * (tractions.imposedOn(raw, foot) - raw);
    }
    field.points.resize(points.size());
    field.point_spacing_m.resize(points.size());
    tractions.imposeOnSurface(field.surface);
    const std::string outside = outsideWarning(*solid_, feet);
    if (!outside.empty()) field.warnings.push_back(outside);
    return result;
}

const TriangleMesh& StressModel::surface() const {
    return solid_->surface();
}
const Settings& StressModel::settings() const {
    return solid_->settings();
}

StressModelReport StressModel::report() const {
    const StressSolverReport& solver = solid_->stressSolver().value()->report();
    const Discretisation& solid = solidOf(*solid_);
    StressModelReport report;
    report.particles = static_cast<int>(solid.particles.size());
    report.surface_points = static_cast<int>(solid.surface_points.size());
    report.unknowns = solver.unknowns;
    report.factor_entries = solver.factor_entries;
    report.factor_bytes = solver.factor_bytes;
    report.reciprocal_condition = solver.reciprocal_condition;
    report.spacing_m = solid.spacing;
    report.wall_thickness_m = solid_->wallThickness();
    report.sample_ms = solid_->sampleMilliseconds();
    report.assemble_ms = solver.assemble_ms;
    report.factor_ms = solver.factor_ms;
    report.warnings = solver.warnings;
    report.repairs = repairs_;
    if (const std::string size = sizeWarning(surface()); !size.empty()) report.warnings.push_back(size);
    if (solid.spacing > solid_->wallThickness())
        report.warnings.push_back(coarseForWalls(solid.spacing, solid_->wallThickness()));
    return report;
}

std::vector<Vec3> StressModel::particlePositions() const {
    return collected(solidOf(*solid_).particles, [](const Particle& p) { return p.position; });
}
std::vector<double> StressModel::particleVolumes() const {
    return collected(solidOf(*solid_).particles, [](const Particle& p) { return p.volume; });
}
std::vector<Vec3> StressModel::surfacePositions() const {
    return collected(solidOf(*solid_).surface_points, [](const SurfacePoint& p) { return p.position; });
}
std::vector<Vec3> StressModel::surfaceNormals() const {
    return collected(solidOf(*solid_).surface_points, [](const SurfacePoint& p) { return p.normal; });
}

}  // namespace sherd
