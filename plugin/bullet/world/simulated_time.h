#pragma once

namespace sherd {

/// Moments of simulated time that differ by less are one: sums of steps round.
constexpr double time_rounding_s = 1e-9;

}  // namespace sherd
