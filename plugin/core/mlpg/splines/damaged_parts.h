#pragma once

#include "core/sampling/discretisation.h"

namespace sherd {

/// Per part, what is left of its stiffness: a ten-thousandth where the particle that owns it is damaged,
/// or 1. `damaged`: #particles, or empty; the result is then empty too.
std::vector<double> stiffnessShares(const Discretisation& solid, const std::vector<char>& damaged);

}  // namespace sherd
