#include "fracture/baked_solid.h"

#include "fracture/breakable_solid.h"

namespace sherd {

namespace {

/// Why a solid of these settings cannot be kept in a file; empty: it can.
std::string whyNot(const Settings& settings) {
    if (settings.strength.field)
        return "settings.strength.field is a function of the program, which a file cannot hold; leave it "
               "out, or make the asset when the program starts, with prepare()";
    if (settings.fracture.guide.custom)
        return "settings.fracture.guide.custom is a function of the program, which a file cannot hold; leave "
               "it out, and give it to the bodies that are made of the asset (BodyOptions::fracture)";
    if (settings.stress.trial_function != TrialFunction::spline)
        return "only the trial functions \"spline\" have a reduced model, which is what a file keeps; set "
               "settings.stress.trial_function";
    if (settings.stress.resample_contacts)
        return "blows with finer grids around their contacts need the factor, which a file does not keep; "
               "set settings.stress.resample_contacts to false";
    return "";
}

}  // namespace

BreakableSolid::BreakableSolid(BakedSolid baked)
    : shared_(std::make_shared<Shared>(std::move(baked.surface))),
      material_(std::move(baked.material)),
      settings_(std::move(baked.settings)),
      supports_(std::move(baked.supports)),
      moments_(baked.moments),
      bounding_radius_(baked.bounding_radius),
      wall_thickness_(baked.wall_thickness),
      spacing_(baked.spacing),
      spacing_of_whole_(baked.spacing) {
    scatterOver(baked.scatter_length);
    KeptModel& kept = baked.model;
    shared_->sampled.get([&] { return Sampled{std::move(kept.sampling), 0, false}; });
    shared_->reduced.get(
        [&]() -> Result<std::shared_ptr<const ReducedStress>> { return std::move(kept.reduced); });
    shared_->prepared = true;
}

std::shared_ptr<const BreakableSolid> BreakableSolid::fromBaked(BakedSolid baked) {
    return std::shared_ptr<const BreakableSolid>(new BreakableSolid(std::move(baked)));
}

Result<BakedSolid> BreakableSolid::baked() const {
    if (const std::string reason = whyNot(settings_); !reason.empty())
        return Error{"The asset cannot be baked: " + reason + "."};
    if (const Status prepared = makeReduced({}); !prepared) return Error{prepared.error()};
    const FractureSettings& fracture = settings_.fracture;
    const bool needs_factor = !fracture.use_reduced_model || fracture.check_with_full_solve;
    if (!needs_factor) (void)prepare({});  // what is left of that is quick
    const auto& reduced = *shared_->reduced.ifMade();
    if (!reduced) return Error{"The asset cannot be baked: " + reduced.error()};
    return BakedSolid{surface(),
                      material_,
                      settings_,
                      supports_,
                      moments_,
                      bounding_radius_,
                      wall_thickness_,
                      spacing_,
                      strength().scatterLength(),
                      {discretisation().value(), reduced.value()}};
}

}  // namespace sherd
