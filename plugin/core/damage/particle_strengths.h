#pragma once

#include <sherd/material.h>

#include <cstdint>
#include <functional>
#include <vector>

#include "core/sampling/discretisation.h"

namespace sherd {

/// Tensile strength of every particle, Pa: scattered about the material's by `seed` and index, normally or
/// after Weibull with its size effect, never below a third of the mean for the particle's volume; times
/// `field` at its place, if there is one. Throws std::invalid_argument where the field is not positive, or
/// below `field_minimum`.
std::vector<double> particleStrengths(const Material& material, const std::vector<Particle>& particles,
                                      std::uint64_t seed,
                                      const std::function<double(const Vec3&)>& field = {},
                                      double field_minimum = 0);

/// The smallest fraction of the material's strength that particleStrengths can give to particles of up to a
/// volume.
double weakestStrengthFraction(const Material& material, double largest_volume_m3);

}  // namespace sherd
