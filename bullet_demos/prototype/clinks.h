#pragma once

#include <cstdint>
#include <vector>

#include "prototype/timbre.h"

namespace prototype {

constexpr int sound_rate_hz = 44100;
using Samples = std::vector<std::int16_t>;

/// The sound of a knock: a few partials that die away, as a struck plate has, and a click of noise.
Samples knock(Timbre timbre);
/// The sound of a break: many knocks, each of a smaller and higher piece than the thing.
Samples shatter(Timbre timbre);

}  // namespace prototype
