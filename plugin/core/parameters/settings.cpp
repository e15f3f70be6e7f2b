#include <sherd/settings.h>

#include "core/parameters/faults.h"

namespace sherd {

namespace {

Status checkCombination(const StressSettings& settings) {
    const bool heaviside = settings.test_function != TestFunction::galerkin;
    const std::string name =
        settings.test_function == TestFunction::heaviside_paper ? "heaviside_paper" : "heaviside";
    if (heaviside && settings.trial_function == TrialFunction::spline)
        return Error{"Spline trial functions go with galerkin test functions; use " + name + " with mls."};
    constexpr int largest_particle_degree = 2;
    if (settings.trial_function != TrialFunction::spline &&
        splineDegree(settings.basis) > largest_particle_degree)
        return Error{
            "The cubic basis is there for spline trial functions; use linear or quadratic with mls and "
            "gmls."};
    if (heaviside && settings.trial_function == TrialFunction::gmls)
        return Error{
            "Heaviside test functions give 3 equations a particle and gmls trial functions have 12 unknowns: "
            "use " +
            name + " with mls, or gmls with galerkin test functions."};
    return success();
}

}  // namespace

Status SamplingSettings::validate() const {
    return statusOf("SamplingSettings", *this);
}

Status StressSettings::validate() const {
    if (const Status ranges = statusOf("StressSettings", *this); !ranges) return ranges;
    return checkCombination(*this);
}

Status StrengthSettings::validate() const {
    return statusOf("StrengthSettings", *this);
}

Status ContactSettings::validate() const {
    return statusOf("ContactSettings", *this);
}

Status GuideField::validate() const {
    return statusOf("GuideField", *this);
}

Status FractureSettings::validate() const {
    return statusOf("FractureSettings", *this);
}

Settings Settings::forQuality(Quality quality) {
    Settings settings;
    SamplingSettings& sampling = settings.sampling;
    StressSettings& stress = settings.stress;
    switch (quality) {
        case Quality::preview:
            sampling.layers_across_wall = 2;
            sampling.smallest_count = 80;
            sampling.fragment_coarsening = 1.3;
            sampling.largest_factor_millions = 1.85;
            sampling.largest_factor_if_thin_millions = 6;
            break;
        case Quality::game:
            break;
        case Quality::film:
            sampling.layers_across_wall = 8;
            sampling.smallest_count = 5000;
            sampling.largest_factor_millions = 90;
            sampling.largest_factor_if_thin_millions = 140;
            sampling.fragment_coarsening = 1;
            stress.resampling_rounds = 3;
            stress.resampling_margin = 3;
            stress.resampling_error = 0.05;
            break;
    }
    return settings;
}

Status Settings::validate() const {
    for (const Status& part :
         {sampling.validate(), stress.validate(), strength.validate(), fracture.validate()})
        if (!part) return part;
    return success();
}

}  // namespace sherd
