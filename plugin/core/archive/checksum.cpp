#include "core/archive/checksum.h"

#define XXH_INLINE_ALL  // nothing to link: the installed library needs no xxHash
#include <xxhash.h>

namespace sherd {

std::uint64_t checksum(const void* bytes, std::size_t size, std::uint64_t seed) {
    return XXH3_64bits_withSeed(bytes, size, seed);
}

}  // namespace sherd
