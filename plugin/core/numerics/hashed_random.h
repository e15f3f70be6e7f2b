#pragma once

#include <cstdint>

#include "core/numerics/split_mix.h"

namespace sherd {

/// A uniform random number in [-1, 1) that depends on the seed, the counter and the component alone, not on
/// how many were drawn before.
inline double hashedRandom(std::uint64_t seed, std::uint64_t counter, std::uint64_t component) {
    const std::uint64_t bits = splitMix64(splitMix64(seed + golden_step * (4 * counter + component + 1)));
    return static_cast<double>(bits >> 11) * 0x1p-52 - 1.0;
}

}  // namespace sherd
