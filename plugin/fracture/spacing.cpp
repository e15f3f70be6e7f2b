#include "fracture/spacing.h"

#include <algorithm>
#include <cmath>

#include "core/mlpg/splines/spacing_choice.h"

namespace sherd {

namespace {

constexpr int fewest_in_fragment = 64, enough_in_sheet = 256;  // particles

double spacingFor(double particles, double volume_m3) {
    return std::cbrt(volume_m3 / particles);
}

}  // namespace

Result<double> spacingOfSolid(const TriangleMesh& surface, const Settings& settings, double volume_m3,
                              double wall_thickness_m) {
    const SamplingSettings& sampling = settings.sampling;
    if (sampling.spacing_m > 0) return std::min(sampling.spacing_m, spacingFor(1, volume_m3));
    const double wished = std::max(std::min(wall_thickness_m / sampling.layers_across_wall,
                                            spacingFor(sampling.smallest_count, volume_m3)),
                                   spacingFor(sampling.largest_count, volume_m3));
    if (settings.stress.trial_function != TrialFunction::spline) return wished;
    constexpr double million = 1e6;
    return chooseSpacing(
        surface,
        {wished, wall_thickness_m, splineDegree(settings.stress.basis),
         million * sampling.largest_factor_millions, million * sampling.largest_factor_if_thin_millions},
        sampling.cells_per_spacing);
}

double fragmentSpacing(double spacing_of_whole_m, const SamplingSettings& sampling, double volume_m3,
                       double area_m2) {
    const double coarsening = sampling.spacing_m > 0 ? 1 : sampling.fragment_coarsening;
    // Below a spacing of thickness particles are as many as there is room for side by side.
    const double of_sheet = std::sqrt(area_m2 / 2 / enough_in_sheet);
    return std::min(coarsening * spacing_of_whole_m,
                    std::max(spacingFor(fewest_in_fragment, volume_m3), of_sheet));
}

}  // namespace sherd
