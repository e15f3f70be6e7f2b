#include "geometry/cutting/label_lattice.h"

#include "core/numerics/hashed_random.h"

namespace sherd {

Vec3 placeOfNode(const LatticeGrid& grid, int node, std::uint64_t seed, int attempt) {
    const auto counter = static_cast<std::uint64_t>(node);
    const std::uint64_t own_seed =
        attempt == 0 ? seed : splitMix64(seed + static_cast<std::uint64_t>(attempt));
    const int row = node / grid.size.x();
    const Vec3 place(node % grid.size.x(), row % grid.size.y(), row / grid.size.y());
    const Vec3 jitter(hashedRandom(own_seed, counter, 0), hashedRandom(own_seed, counter, 1),
                      hashedRandom(own_seed, counter, 2));
    return grid.origin + grid.spacing * (place + grid.jitter * jitter);
}

}  // namespace sherd
