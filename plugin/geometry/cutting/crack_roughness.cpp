#include "geometry/cutting/crack_roughness.h"

#include <algorithm>

#include "core/numerics/hashed_random.h"
#include "core/numerics/mesh_measures.h"

namespace sherd {

void roughenCracks(CrackComplex& complex, const LabelLattice& lattice, double amplitude, std::uint64_t seed) {
    for (const auto& [a, b, c] : complex.triangles)
        complex.smooth_normals.push_back(
            areaVector({complex.points[a], complex.points[b], complex.points[c]}).normalized());
    for (std::size_t p = 0; p < complex.origins.size(); ++p) {
        CrackPoint& origin = complex.origins[p];
        if (!origin.isOnEdge() || origin.fixed) continue;
        const double length = (lattice.nodes[origin.nodes[1]] - lattice.nodes[origin.nodes[0]]).norm();
        const double least = lattice.smallest_edge_place;
        constexpr std::uint64_t component = 3;  // 0 to 2 move the lattice's nodes
        const double random = hashedRandom(seed, p, component);
        // The move is scaled to the room there is. Were it clamped, points would gather at the ends.
        const double room = random > 0 ? 1 - least - origin.t : origin.t - least;
        origin.t = clampToEdge(origin.t + random * std::min(room, amplitude / length), least);
    }
    placePoints(complex, lattice);
}

}  // namespace sherd
