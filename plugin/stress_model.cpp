#include <sherd/stress_model.h>

#include <algorithm>
#include <sstream>

#include "body.h"
#include "core/loads/surface_region.h"
#include "core/stress/surface_traction.h"
#include "geometry/surface_checks.h"
#include "geometry/surface_feet.h"

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

/// A load as it acts on a body's surface.
struct ActingLoad {
    SurfaceLoad load;
    double area_m2 = 0;

    Vec3 traction(const Vec3& normal) const { return load.force_n / area_m2 - load.pressure_pa * normal; }
};

/// The stress at a point of the surface with the traction that acts there; on supports, and without a normal, `raw`.
Voigt withActingTraction(const std::vector<ActingLoad>& loads, const Body& body, const Vec3& point, const Vec3& normal,
                         const Voigt& raw) {
    const auto isOn = [&](const SurfaceRegion& region) { return contains(region, point, normal); };
    if (normal.isZero() || std::any_of(body.supports().begin(), body.supports().end(), isOn)) return raw;
    Vec3 traction = Vec3::Zero();
    for (const ActingLoad& acting : loads)
        if (isOn(acting.load.region)) traction += acting.traction(normal);
    return withTraction(raw, normal, traction, Elasticity(body.material()));
}

/// Where the change that a traction makes at the surface has died away, in particle spacings: about as far as the
/// nearest points at which the gradients of quadratic splines are superconvergent.
constexpr double traction_depth = 0.25;

/// Feet on the surface of those points that lie within that depth, and whose feet have a normal.
struct ShallowPoints {
    std::vector<std::size_t> index;
    std::vector<SurfaceFoot> feet;
};

ShallowPoints shallowPoints(const Body& body, const std::vector<Vec3>& points) {
    constexpr double near_edge = 0.005;  // of the wall thickness
    const double depth = traction_depth * body.spacing();
    ShallowPoints shallow;
    std::size_t index = 0;
    for (const SurfaceFoot& foot : surfaceFeet(body.surface(), points, near_edge * body.wallThickness())) {
        if (foot.distance < depth && !foot.normal.isZero()) {
            shallow.index.push_back(index);
            shallow.feet.push_back(foot);
        }
        ++index;
    }
    return shallow;
}

/// Of a body whose solver is there.
const Discretisation& solidOf(const Body& body) {
    return *body.solid().value();
}

}  // namespace

Result<StressModel> StressModel::make(const TriangleMesh& surface, const Material& material,
                                      const Settings& settings, const std::vector<SurfaceRegion>& supports) {
    if (const Status sound = checkSurface(surface); !sound) return Error{sound.error()};
    Settings resampled = settings;
    resampled.fracture.resample_contacts = true;
    auto body = Body::make(surface, material, resampled, supports);
    if (!body) return Error{body.error()};
    if (const auto solver = body.value()->stressSolver(); !solver) return Error{solver.error()};
    return StressModel(std::move(body).value());
}

Result<StressField> StressModel::solve(const std::vector<SurfaceLoad>& loads, const std::vector<Vec3>& points,
                                       const Vec3& spin_rad_s) const {
    std::vector<PointForce> forces;
    std::vector<ActingLoad> acting;
    for (const SurfaceLoad& load : loads) {
        const auto area = regionQuadrature(surface(), load.region, body_->quadratureSpacing());
        if (!area) return Error{"A load cannot be placed. " + area.error()};
        const std::vector<PointForce> part = pointForces(load, area.value());
        forces.insert(forces.end(), part.begin(), part.end());
        acting.push_back({load, 0});
        for (const AreaPoint& point : area.value()) acting.back().area_m2 += point.area_m2;
    }
    const ShallowPoints shallow = shallowPoints(*body_, points);
    std::vector<Vec3> asked = points;
    for (const SurfaceFoot& foot : shallow.feet) asked.push_back(foot.position);
    Result<StressField> result = body_->stressSolver().value()->solve(forces, asked, spin_rad_s);
    if (!result) return result;
    StressField& field = result.value();
    for (std::size_t i = 0; i < shallow.feet.size(); ++i) {
        const SurfaceFoot& foot = shallow.feet[i];
        const Voigt& raw = field.points[points.size() + i];
        const double depth = traction_depth * field.point_spacing_m[shallow.index[i]];
        if (foot.distance > depth) continue;
        field.points[shallow.index[i]] +=
            (1 - foot.distance / depth) * (withActingTraction(acting, *body_, foot.position, foot.normal, raw) - raw);
    }
    field.points.resize(points.size());
    field.point_spacing_m.resize(points.size());
    const std::vector<SurfacePoint>& surface_points = solidOf(*body_).surface_points;
    for (std::size_t q = 0; q < surface_points.size(); ++q)
        field.surface[q] = withActingTraction(acting, *body_, surface_points[q].position, surface_points[q].normal,
                                              field.surface[q]);
    return result;
}

const TriangleMesh& StressModel::surface() const {
    return body_->surface();
}
const Settings& StressModel::settings() const {
    return body_->settings();
}

StressModelReport StressModel::report() const {
    const StressSolverReport& solver = body_->stressSolver().value()->report();
    const Discretisation& solid = solidOf(*body_);
    StressModelReport report;
    report.particles = static_cast<int>(solid.particles.size());
    report.surface_points = static_cast<int>(solid.surface_points.size());
    report.unknowns = solver.unknowns;
    report.factor_entries = solver.factor_entries;
    report.factor_bytes = solver.factor_entries * static_cast<long long>(sizeof(double));
    report.reciprocal_condition = solver.reciprocal_condition;
    report.spacing_m = solid.spacing;
    report.wall_thickness_m = body_->wallThickness();
    report.sample_ms = body_->sampleMilliseconds();
    report.assemble_ms = solver.assemble_ms;
    report.factor_ms = solver.factor_ms;
    report.warnings = solver.warnings;
    if (solid.spacing > body_->wallThickness()) report.warnings.push_back(coarseForWalls(solid.spacing, body_->wallThickness()));
    return report;
}

std::vector<Vec3> StressModel::particlePositions() const {
    return collected(solidOf(*body_).particles, [](const Particle& p) { return p.position; });
}
std::vector<double> StressModel::particleVolumes() const {
    return collected(solidOf(*body_).particles, [](const Particle& p) { return p.volume; });
}
std::vector<Vec3> StressModel::surfacePositions() const {
    return collected(solidOf(*body_).surface_points, [](const SurfacePoint& p) { return p.position; });
}
std::vector<Vec3> StressModel::surfaceNormals() const {
    return collected(solidOf(*body_).surface_points, [](const SurfacePoint& p) { return p.normal; });
}

}  // namespace sherd
