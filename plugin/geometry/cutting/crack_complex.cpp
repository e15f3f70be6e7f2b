#include "geometry/cutting/crack_complex.h"

#include <algorithm>

namespace sherd {

double clampToEdge(double t) {
    return std::min(1 - smallest_edge_place, std::max(smallest_edge_place, t));
}

Vec3 positionOf(const CrackPoint& point, const CrackComplex& complex, const LabelLattice& lattice) {
    if (point.isOnEdge())
        return (1 - point.t) * lattice.nodes[point.nodes[0]] + point.t * lattice.nodes[point.nodes[1]];
    Vec3 position = Vec3::Zero();
    for (int i = 0; i < 4; ++i)
        if (point.between[i] >= 0) position += point.weights[i] * complex.points[point.between[i]];
    return position;
}

void placePoints(CrackComplex& complex, const LabelLattice& lattice) {
    for (std::size_t p = 0; p < complex.points.size(); ++p)
        complex.points[p] = positionOf(complex.origins[p], complex, lattice);
}

}  // namespace sherd
