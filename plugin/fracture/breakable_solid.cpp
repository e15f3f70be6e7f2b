#include "fracture/breakable_solid.h"

#include <algorithm>
#include <cmath>

#include "core/clustering/wall_axes.h"
#include "core/damage/material_strength.h"
#include "core/numerics/mesh_measures.h"
#include "core/numerics/split_mix.h"
#include "core/numerics/stopwatch.h"
#include "core/sampling/sample_solid.h"
#include "fracture/spacing.h"
#include "fracture/supports.h"
#include "geometry/mass_properties.h"
#include "geometry/surface_checks.h"

namespace sherd {

namespace {

double boundingRadiusAbout(const Vec3& centre, const TriangleMesh& surface) {
    double squared = 0;
    for (const Vec3& v : surface.vertices) squared = std::max(squared, (v - centre).squaredNorm());
    return std::sqrt(squared);
}

/// Spline functions are integrated with moments of twice their degree; other forms need none.
int momentOrder(const StressSettings& stress) {
    return stress.trial_function == TrialFunction::spline ? 2 * splineDegree(stress.basis) : 0;
}

}  // namespace

BreakableSolid::BreakableSolid(TriangleMesh surface, const Material& material, const Settings& settings)
    : shared_(std::make_shared<Shared>(std::move(surface))),
      material_(material),
      settings_(settings),
      moments_(solidMoments(this->surface())),
      bounding_radius_(boundingRadiusAbout(moments_.centroid, this->surface())) {}

Result<std::shared_ptr<const BreakableSolid>> BreakableSolid::make(TriangleMesh surface,
                                                                   const Material& material,
                                                                   const Settings& settings,
                                                                   std::vector<SurfaceRegion> supports) {
    if (const Status valid = material.validate(); !valid) return Error{valid.error()};
    if (const Status valid = settings.validate(); !valid) return Error{valid.error()};
    std::shared_ptr<BreakableSolid> solid(new BreakableSolid(std::move(surface), material, settings));
    const double volume = solid->moments_.volume;
    solid->supports_ = std::move(supports);
    solid->settings_.sampling.moment_order = momentOrder(settings.stress);
    solid->wall_thickness_ = sherd::wallThickness(solid->surface());
    const Result<double> spacing = spacingOfSolid(solid->surface(), settings, volume, solid->wall_thickness_);
    if (!spacing) return Error{spacing.error()};
    solid->spacing_ = solid->spacing_of_whole_ = spacing.value();
    solid->scatterOver(scatterLength(volume, solid->wall_thickness_));
    return std::shared_ptr<const BreakableSolid>(solid);
}

std::shared_ptr<const BreakableSolid> BreakableSolid::makeFragment(TriangleMesh surface) const {
    std::shared_ptr<BreakableSolid> piece(new BreakableSolid(std::move(surface), material_, settings_));
    const double volume = piece->moments_.volume;
    piece->wall_thickness_ = std::min(wall_thickness_, std::cbrt(volume));
    piece->spacing_of_whole_ = spacing_of_whole_;
    piece->spacing_ =
        fragmentSpacing(piece->spacing_of_whole_, settings_.sampling, volume, surfaceArea(piece->surface()));
    piece->scatterOver(strength().scatterLength());
    piece->is_fragment_ = true;
    piece->supports_ = supportsThatHold(piece->surface(), supports_, piece->spacing_, piece->wall_thickness_);
    return piece;
}

std::shared_ptr<const BreakableSolid> BreakableSolid::anchored(std::vector<SurfaceRegion> supports) const {
    std::shared_ptr<BreakableSolid> solid(new BreakableSolid(surface(), material_, settings_));
    solid->wall_thickness_ = wall_thickness_;
    solid->spacing_ = spacing_;
    solid->spacing_of_whole_ = spacing_of_whole_;
    solid->scatterOver(strength().scatterLength());
    solid->is_fragment_ = is_fragment_;
    solid->supports_ = std::move(supports);
    return solid;
}

std::shared_ptr<const BreakableSolid> BreakableSolid::anchoredTogether(
    const std::vector<SurfaceRegion>& supports) const {
    const std::lock_guard<std::mutex> lock(shared_->holding);
    auto& held = shared_->held;
    held.erase(std::remove_if(held.begin(), held.end(), [](const auto& solid) { return solid.expired(); }),
               held.end());
    for (const auto& known : held)
        if (const auto solid = known.lock(); solid && solid->supports_ == supports &&
                                             solid->settings_.strength.seed == settings_.strength.seed)
            return solid;
    const auto made = anchored(supports);
    held.push_back(made);
    return made;
}

std::shared_ptr<const BreakableSolid> BreakableSolid::ofBody(std::uint64_t seed) const {
    std::shared_ptr<BreakableSolid> body(new BreakableSolid(*this));
    body->settings_.strength.seed = splitMix64(settings_.strength.seed + golden_step * (seed + 1));
    body->scatterOver(strength().scatterLength());
    return body;
}

std::shared_ptr<const BreakableSolid> BreakableSolid::unsolved() const {
    std::shared_ptr<BreakableSolid> same(new BreakableSolid(*this));
    same->solver_ = std::make_shared<MadeOnce<Result<StressSolver>>>();
    return same;
}

const FailureCriterion& BreakableSolid::failureCriterion() const {
    return *sherd::failureCriterion(material_.failure_criterion);
}

const SurfaceTree& BreakableSolid::surfaceTree() const {
    return shared_->tree.get([&] { return SurfaceTree(surface()); });
}

const CuttableSolid& BreakableSolid::cuttable(const Discretisation& sampling) const {
    return shared_->cuttable.get([&] { return CuttableSolid(surface(), sampling); });
}

const std::vector<Vec3>& BreakableSolid::wallAxes(const Discretisation& sampling) const {
    return shared_->wall_axes.get([&] { return sherd::wallAxes(sampling); });
}

BreakableSolid::Sampled BreakableSolid::sampled() const {
    const Stopwatch watch;
    constexpr int quick_order = 4;  // of moments; who asks for cubic splines wants all digits
    const bool quick = is_fragment_ && settings_.sampling.moment_order <= quick_order;
    Result<Discretisation> sampled =
        sampleSolid(surface(), spacing_, settings_.sampling, quick ? MomentRule::quick : MomentRule::exact);
    const double ms = watch.milliseconds();
    if (!sampled) return {Error{sampled.error()}, ms};
    return {std::make_shared<const Discretisation>(std::move(sampled).value()), ms};
}

Result<std::shared_ptr<const Discretisation>> BreakableSolid::discretisation() const {
    return shared_->sampled.get([&] { return sampled(); }).discretisation;
}

Result<std::shared_ptr<const Discretisation>> BreakableSolid::completeDiscretisation() const {
    const auto kept = discretisation();
    if (!kept || shared_->sampled.ifMade()->is_complete) return kept;
    const auto& complete = shared_->complete.get([&] { return sampled(); }).discretisation;
    if (!complete) return complete;
    if (complete.value()->particles.size() != kept.value()->particles.size() ||
        complete.value()->cells.size() != kept.value()->cells.size() ||
        complete.value()->voxels.size() != kept.value()->voxels.size())
        return Error{
            "The asset was baked by a program that samples solids in another way than this one; bake it "
            "again."};
    return complete;
}

Result<const StressSolver*> BreakableSolid::stressSolver() const {
    const Result<StressSolver>& solver = solver_->get([&] { return stressSolverWithout({}); });
    if (!solver) return Error{solver.error()};
    return &solver.value();
}

Status BreakableSolid::prepare(const Progress& progress) const {
    const auto tell = [&](double done) {
        if (progress) progress(done);
    };
    tell(0);
    const FractureSettings& fracture = settings_.fracture;
    const bool reduced = fracture.use_reduced_model && makeReduced(progress);
    if (!reduced || fracture.check_with_full_solve)
        if (const auto solver = stressSolver(); !solver) return Error{solver.error()};
    prepareSurface();
    if (reduced) (void)strength().weakest(reducedStress()->reading);  // of bodies without a seed of their own
    shared_->prepared = true;
    tell(1);
    return success();
}

void BreakableSolid::prepareSurface() const {
    surfaceTree();
    if (const auto sampling = discretisation(); sampling) cuttable(*sampling.value());
}

Status BreakableSolid::makeReduced(const Progress& progress) const {
    const StressSettings& stress = settings_.stress;
    if (stress.trial_function != TrialFunction::spline || stress.resample_contacts)
        return Error{"A reduced model needs spline trial functions, and contacts that are not resampled."};
    const auto& reduced = shared_->reduced.get([&]() -> Result<std::shared_ptr<const ReducedStress>> {
        if (const Result<StressSolver>* made = solver_->ifMade(); made && *made)
            return made->value().reduced(progress);
        // Neither its factor is kept, nor what else only makes it, unless something has asked for that
        // before.
        const Sampled* const before = shared_->sampled.ifMade();
        Sampled complete = before ? *before : sampled();
        const Result<StressSolver> solver = solverOn(complete.discretisation, {}, Precision::full);
        const auto made = solver ? solver.value().reduced(progress) : Error{solver.error()};
        KeptModel kept;
        if (made && !before) {
            kept = asKept({complete.discretisation.value(), made.value()}, material_);
            complete.is_complete = kept.reduced == made.value();
            complete.discretisation = kept.sampling;
        }
        shared_->sampled.get([&] { return complete; });
        return kept.reduced ? Result<std::shared_ptr<const ReducedStress>>(kept.reduced) : made;
    });
    if (!reduced) return Error{reduced.error()};
    return success();
}

const ReducedStress* BreakableSolid::reducedStress() const {
    const auto* reduced = shared_->reduced.ifMade();
    return reduced && *reduced ? reduced->value().get() : nullptr;
}

Result<StressSolver> BreakableSolid::stressSolverWithout(const std::vector<char>& damaged,
                                                         Precision precision) const {
    return solverOn(completeDiscretisation(), damaged, precision);
}

Result<StressSolver> BreakableSolid::solverOn(const Result<std::shared_ptr<const Discretisation>>& sampled,
                                              const std::vector<char>& damaged, Precision precision) const {
    if (!sampled) return Error{sampled.error()};
    const auto supports = pointsOfSupports(surface(), supports_, quadratureSpacing());
    if (!supports) return Error{supports.error()};
    StressSettings stress = settings_.stress;
    if (!stress.resample_contacts) stress.resampling_rounds = 0;
    return StressSolver::build(sampled.value(), material_, stress, supports.value(), damaged, precision);
}

Result<CoarseModel> BreakableSolid::makeCoarseModel() const {
    // Coarser than its own sampling, or than what a fragment of fine sampling would have: a look at an even
    // coarser grid would decide less.
    constexpr double coarser = 2.5, fine = 1.3;
    const auto supports = pointsOfSupports(surface(), supports_, quadratureSpacing());
    if (!supports) return Error{supports.error()};
    return CoarseModel::make(surface(), coarser * std::min(spacing_, fine * spacing_of_whole_), material_,
                             supports.value());
}

void BreakableSolid::scatterOver(double length_m) {
    strength_ = std::make_shared<const BodyStrength>(material_, length_m, settings_.strength);
}

double BreakableSolid::cellVolume() const {
    return std::min(std::pow(std::min(spacing_, wall_thickness_), 3), moments_.volume);
}

double BreakableSolid::smallestFailureEnergy() const {
    return shared_->smallest_failure_energy.get([&] {
        return failureCriterion().least_energy_density_j_m3(strength().at().least(), material_) *
               settings_.sampling.smallest_fill * cellVolume();
    });
}

double BreakableSolid::quadratureSpacing() const {
    constexpr double of_finest_cell = 1.0 / 3;
    return of_finest_cell * spacing_ / std::pow(2, settings_.stress.resampling_rounds);
}

double BreakableSolid::sampleMilliseconds() const {
    const Sampled* sampled = shared_->sampled.ifMade();
    return sampled ? sampled->ms : 0;
}

int BreakableSolid::unknownCount() const {
    if (const ReducedStress* reduced = reducedStress())
        return 3 * reduced->model.problem().space->function_count;
    return isFactored() ? solver_->ifMade()->value().report().unknowns : 0;
}

bool BreakableSolid::isFactored() const {
    const Result<StressSolver>* solver = solver_->ifMade();
    return solver && solver->ok();
}

bool BreakableSolid::hasSolver() const {
    return isFactored() || reducedStress() || expectsFactor();
}

}  // namespace sherd
