#pragma once

#include <cstddef>
#include <cstdint>

namespace sherd {

/// XXH3, 64 bits; another `seed`, another sum.
std::uint64_t checksum(const void* bytes, std::size_t size, std::uint64_t seed = 0);

}  // namespace sherd
