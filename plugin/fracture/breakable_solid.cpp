#include "fracture/breakable_solid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/damage/particle_strengths.h"
#include "core/loads/surface_region.h"
#include "core/mlpg/splines/spacing_choice.h"
#include "core/numerics/stopwatch.h"
#include "core/sampling/sample_solid.h"
#include "geometry/mass_properties.h"
#include "geometry/surface_checks.h"

namespace sherd {

namespace {

constexpr double smallest_fragment = 1.0 / 200;  // of the first body's volume, when the settings do not say
constexpr int fewest_in_fragment = 64;  // particles; a given spacing is refined in fragments below this

double boundingRadiusAbout(const Vec3& centre, const TriangleMesh& surface) {
    double squared = 0;
    for (const Vec3& v : surface.vertices) squared = std::max(squared, (v - centre).squaredNorm());
    return std::sqrt(squared);
}

/// From the wall thickness and the limits on counts; a given spacing is taken as it is.
double wishedSpacing(const SamplingSettings& sampling, double volume, double wall_thickness) {
    const auto spacing_for = [&](double count) { return std::cbrt(volume / count); };
    if (sampling.spacing_m > 0) return std::min(sampling.spacing_m, spacing_for(1));
    return std::max(
        std::min(wall_thickness / sampling.layers_across_wall, spacing_for(sampling.smallest_count)),
        spacing_for(sampling.largest_count));
}

/// The same, made coarser until the factor of the stiffness matrix is as small as is wished.
Result<double> chosenSpacing(const TriangleMesh& surface, const Settings& settings, double volume,
                             double wall_thickness) {
    const double wished = wishedSpacing(settings.sampling, volume, wall_thickness);
    if (settings.sampling.spacing_m > 0 || settings.stress.trial_function != TrialFunction::spline)
        return wished;
    constexpr double million = 1e6;
    return chooseSpacing(surface,
                         {wished, wall_thickness, splineDegree(settings.stress.basis),
                          million * settings.sampling.largest_factor_millions,
                          million * settings.sampling.largest_factor_if_thin_millions},
                         settings.sampling.cells_per_spacing);
}

/// Spline functions are integrated with moments of twice their degree; other forms need none.
int momentOrder(const StressSettings& stress) {
    return stress.trial_function == TrialFunction::spline ? 2 * splineDegree(stress.basis) : 0;
}

Result<std::vector<SupportPoint>> supportPoints(const TriangleMesh& surface,
                                                const std::vector<SurfaceRegion>& regions, double spacing) {
    std::vector<SupportPoint> supports;
    for (const SurfaceRegion& region : regions) {
        const auto points = regionQuadrature(surface, region, spacing);
        if (!points) return Error{"A support cannot be placed: " + points.error()};
        for (const AreaPoint& p : points.value()) supports.push_back({p.position, p.area_m2});
    }
    return supports;
}

}  // namespace

Result<std::shared_ptr<const BreakableSolid>> BreakableSolid::make(TriangleMesh surface,
                                                                   const Material& material,
                                                                   const Settings& settings,
                                                                   std::vector<SurfaceRegion> supports) {
    if (const Status valid = material.validate(); !valid) return Error{valid.error()};
    if (const Status valid = settings.validate(); !valid) return Error{valid.error()};
    std::shared_ptr<BreakableSolid> body(new BreakableSolid);
    body->surface_ = std::move(surface);
    body->material_ = material;
    body->settings_ = settings;
    body->supports_ = std::move(supports);
    body->moments_ = solidMoments(body->surface_);
    const double volume = body->moments_.volume;
    body->wall_thickness_ = sherd::wallThickness(body->surface_);
    body->bounding_radius_ = boundingRadiusAbout(body->moments_.centroid, body->surface_);
    const Result<double> spacing = chosenSpacing(body->surface_, settings, volume, body->wall_thickness_);
    if (!spacing) return Error{spacing.error()};
    body->spacing_ = spacing.value();
    body->settings_.sampling.moment_order = momentOrder(settings.stress);
    const double given = settings.fracture.smallest_fragment_m3;
    body->smallest_fragment_m3_ = given > 0 ? given : smallest_fragment * volume;
    return std::shared_ptr<const BreakableSolid>(body);
}

std::shared_ptr<const BreakableSolid> BreakableSolid::makeFragment(TriangleMesh surface) const {
    std::shared_ptr<BreakableSolid> piece(new BreakableSolid);
    piece->surface_ = std::move(surface);
    piece->material_ = material_;
    piece->settings_ = settings_;
    piece->moments_ = solidMoments(piece->surface_);
    const double volume = piece->moments_.volume;
    piece->wall_thickness_ = std::min(wall_thickness_, std::cbrt(volume));
    piece->bounding_radius_ = boundingRadiusAbout(piece->moments_.centroid, piece->surface_);
    // As fine as the whole, or finer where that would leave it too few particles.
    SamplingSettings sampling = settings_.sampling;
    sampling.spacing_m = std::min(spacing_, std::cbrt(volume / fewest_in_fragment));
    piece->spacing_ = wishedSpacing(sampling, volume, piece->wall_thickness_);
    piece->smallest_fragment_m3_ = smallest_fragment_m3_;
    return piece;
}

const FailureCriterion& BreakableSolid::failureCriterion() const {
    return *sherd::failureCriterion(material_.failure_criterion);
}

Result<std::shared_ptr<const Discretisation>> BreakableSolid::discretisation() const {
    const std::lock_guard<std::recursive_mutex> lock(once_);
    if (!discretisation_ && trouble_.empty()) {
        const Stopwatch watch;
        Result<Discretisation> sampled = sampleSolid(surface_, spacing_, settings_.sampling);
        if (sampled)
            discretisation_ = std::make_shared<const Discretisation>(std::move(sampled).value());
        else
            trouble_ = sampled.error();
        sample_ms_ = watch.milliseconds();
    }
    if (!discretisation_) return Error{trouble_};
    return discretisation_;
}

Result<const StressSolver*> BreakableSolid::stressSolver() const {
    const std::lock_guard<std::recursive_mutex> lock(once_);
    if (const auto sampled = discretisation(); !sampled) return Error{sampled.error()};
    if (!solver_ && trouble_.empty()) {
        Result<StressSolver> built = stressSolverWithout({});
        if (built)
            solver_ = std::make_unique<StressSolver>(std::move(built).value());
        else
            trouble_ = built.error();
    }
    if (!solver_) return Error{trouble_};
    return static_cast<const StressSolver*>(solver_.get());
}

Result<StressSolver> BreakableSolid::stressSolverWithout(const std::vector<char>& damaged) const {
    const auto sampled = discretisation();
    if (!sampled) return Error{sampled.error()};
    const auto supports = supportPoints(surface_, supports_, quadratureSpacing());
    if (!supports) return Error{supports.error()};
    StressSettings stress = settings_.stress;
    if (!settings_.fracture.resample_contacts) stress.resampling_rounds = 0;
    return StressSolver::build(sampled.value(), material_, stress, supports.value(), damaged);
}

const std::vector<double>& BreakableSolid::strengths(const Discretisation& solid) const {
    const std::lock_guard<std::recursive_mutex> lock(once_);
    if (strengths_.empty())
        strengths_ = particleStrengths(material_, solid.particles, settings_.fracture.seed,
                                       settings_.fracture.strength_field);
    return strengths_;
}

double BreakableSolid::weakestPlace() const {
    const auto& field = settings_.fracture.strength_field;
    if (!field) return 1;
    const auto sampled = discretisation();
    if (!sampled) return 0;
    const std::lock_guard<std::recursive_mutex> lock(once_);
    if (weakest_place_ >= 0) return weakest_place_;
    weakest_place_ =
        0;  // for a field that throws or is not above 0 and finite: the blow then says what is wrong
    try {
        double weakest = std::numeric_limits<double>::infinity();
        for (const Particle& particle : sampled.value()->particles) {
            const double here = field(particle.position);
            if (!(here > 0) || !std::isfinite(here)) return 0;
            weakest = std::min(weakest, here);
        }
        weakest_place_ = weakest;
    } catch (...) {  // whatever an app's function throws
    }
    return weakest_place_;
}

double BreakableSolid::quadratureSpacing() const {
    constexpr double of_finest_cell = 1.0 / 3;
    return of_finest_cell * spacing_ / std::pow(2, settings_.stress.resampling_rounds);
}

bool BreakableSolid::prepared() const {
    const std::lock_guard<std::recursive_mutex> lock(once_);
    return solver_ != nullptr;
}

}  // namespace sherd
