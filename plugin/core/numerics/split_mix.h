#pragma once

#include <cstdint>

namespace sherd {

/// 2^64 divided by the golden ratio: the step between the states of SplitMix64.
constexpr std::uint64_t golden_step = 0x9e3779b97f4a7c15ULL;

/// The output of SplitMix64 for a state (Steele, Lea and Flood 2014): neighbouring states give unrelated
/// numbers.
constexpr std::uint64_t splitMix64(std::uint64_t state) {
    std::uint64_t z = state + golden_step;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

}  // namespace sherd
