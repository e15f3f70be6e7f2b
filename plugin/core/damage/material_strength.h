#pragma once

#include <sherd/material.h>
#include <sherd/settings.h>
#include <sherd/types.h>

#include "core/sampling/discretisation.h"

namespace sherd {

/// Tensile strength at every point of a body, in the coordinates of the body that was whole at first. It
/// depends on the point alone, so that a finer grid, or a fragment, finds what a coarse one, or the whole
/// body, found there.
///
/// The scatter is a continuous Gaussian random field: independent normal numbers at the nodes of a lattice,
/// interpolated and divided by the standard deviation of the sum. Its values are scattered normally about the
/// material's strength, or after Weibull. The weakest point of a volume V then has the mean strength
/// `tensile_strength_pa` (`weibull_volume_m3` / V)^(1/m): a point stands for the part of a lattice cell that
/// makes it so.
class MaterialStrength {
  public:
    /// `scatter_length_m`: edge of a lattice cell, see `scatterLength`.
    MaterialStrength(const Material& material, double scatter_length_m, const StrengthSettings& settings);

    /// The strength at x (m), Pa; never below a third of the mean, times the settings' field there. Throws
    /// std::invalid_argument where the field is not positive, or below its minimum.
    double at(const Vec3& x) const;

    /// Whether `at` calls the app: then it is not to be asked on several threads.
    bool hasField() const { return static_cast<bool>(settings_.field); }

    /// Nowhere is it less, Pa; 0 if that is not known of the settings' field.
    double least() const;

  private:
    double scattered(const Vec3& x) const;

    StrengthSettings settings_;
    double mean_pa_;          ///< of a point
    double scatter_;          ///< of a normal distribution, over the mean
    double weibull_modulus_;  ///< 0: the distribution is normal
    double weibull_scale_;    ///< of a distribution with the mean 1
    double scatter_length_m_;
};

/// Over what distance the strength of a solid scatters, m: so far that the coarsest quality still resolves
/// it. Follows from the shape of the body that is whole at first, not from its sampling.
double scatterLength(double volume_m3, double wall_thickness_m);

/// The strengths where a full solve reads the stress, Pa: at the particles, then at the surface points.
std::vector<double> strengthsAtSamples(const MaterialStrength& strength, const Discretisation& sampling);

}  // namespace sherd
