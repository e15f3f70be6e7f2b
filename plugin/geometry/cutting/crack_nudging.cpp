#include "geometry/cutting/crack_nudging.h"

#include "core/numerics/hashed_random.h"

namespace sherd {

namespace {

constexpr double largest_nudge = 0.02;  // of a lattice edge

void nudgePoint(CrackComplex& complex, const LabelLattice& lattice, int point, std::uint64_t seed,
                int attempt) {
    CrackPoint& origin = complex.origins[point];
    if (origin.isOnEdge()) {
        const double move = largest_nudge * hashedRandom(seed, static_cast<std::uint64_t>(point),
                                                         static_cast<std::uint64_t>(attempt));
        const double moved = origin.t + move;
        origin.t = moved == clampToEdge(moved, lattice.smallest_edge_place) ? moved : origin.t - move;
        return;
    }
    for (int p : origin.between)
        if (p >= 0) nudgePoint(complex, lattice, p, seed, attempt);
}

}  // namespace

void nudgeTriangle(CrackComplex& complex, const LabelLattice& lattice, int triangle, std::uint64_t seed,
                   int attempt) {
    for (int p : complex.triangles[triangle]) nudgePoint(complex, lattice, p, seed, attempt);
    placePoints(complex, lattice);
}

}  // namespace sherd
