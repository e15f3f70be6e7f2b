#include <sherd/stress_model.h>

#include <algorithm>
#include <sstream>

#include "body.h"
#include "core/loads/surface_region.h"
#include "core/stress/surface_traction.h"
#include "geometry/surface_checks.h"
#include "geometry/surface_normals.h"

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

/// The stresses at `points`, where the surface has the given normals (zero: none), with the tractions that act there;
/// those on supports are not known.
void imposeTractions(const std::vector<ActingLoad>& loads, const Body& body, const std::vector<Vec3>& points,
                     const std::vector<Vec3>& normals, std::vector<Voigt>& stresses) {
    const Elasticity elasticity(body.material());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3& normal = normals[i];
        const auto isOn = [&](const SurfaceRegion& region) { return contains(region, points[i], normal); };
        if (normal.isZero() || std::any_of(body.supports().begin(), body.supports().end(), isOn)) continue;
        Vec3 traction = Vec3::Zero();
        for (const ActingLoad& acting : loads)
            if (isOn(acting.load.region)) traction += acting.traction(normal);
        stresses[i] = withTraction(stresses[i], normal, traction, elasticity);
    }
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
    Result<StressField> field = body_->stressSolver().value()->solve(forces, points, spin_rad_s);
    if (!field) return field;
    constexpr double on_surface = 0.005;  // of the wall thickness
    imposeTractions(acting, *body_, points,
                    sherd::surfaceNormals(surface(), points, on_surface * body_->wallThickness()),
                    field.value().points);
    imposeTractions(acting, *body_, surfacePositions(), surfaceNormals(), field.value().surface);
    return field;
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
