#pragma once

#include <cstdint>

namespace sherd {

/// A uniform number in [-1, 1) that depends on nothing but the seed and two counters (splitmix64), so that it
/// is the same in whatever order it is asked for.
inline double hashedRandom(std::uint64_t seed, std::uint64_t counter, std::uint64_t component) {
    std::uint64_t z = seed + 0x9e3779b97f4a7c15ULL * (4 * counter + component + 1);
    for (int round = 0; round < 2; ++round) {
        z += 0x9e3779b97f4a7c15ULL;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        z ^= z >> 31;
    }
    return static_cast<double>(z >> 11) * 0x1p-52 - 1.0;
}

}  // namespace sherd
