#include "geometry/cutting/crack_complex.h"

#include <algorithm>

namespace sherd {

double clampToEdge(double t, double least) {
    return std::min(1 - least, std::max(least, t));
}

Vec3 positionOf(const CrackPoint& point, const CrackComplex& complex, const LabelLattice& lattice) {
    if (point.isOnEdge())
        return (1 - point.t) * lattice.nodes[point.nodes[0]] + point.t * lattice.nodes[point.nodes[1]];
    Vec3 position = Vec3::Zero();
    for (int i = 0; i < 4; ++i)
        if (point.between[i] >= 0) position += point.weights[i] * complex.points[point.between[i]];
    return position;
}

void placeInFace(CrackPoint& point, const CrackComplex& complex, const Vec3& wanted, double least) {
    const Vec3 &a = complex.points[point.between[0]], &b = complex.points[point.between[1]],
               &c = complex.points[point.between[2]];
    const Vec3 normal = (b - a).cross(c - a);
    std::array<double, 4> w = {normal.dot((b - wanted).cross(c - wanted)),
                               normal.dot((c - wanted).cross(a - wanted)),
                               normal.dot((a - wanted).cross(b - wanted)), 0};
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += w[i] = std::max(least, w[i] / normal.squaredNorm());
    for (double& weight : w) weight /= sum;
    point.weights = w;
}

void placePoints(CrackComplex& complex, const LabelLattice& lattice) {
    for (std::size_t p = 0; p < complex.points.size(); ++p)
        complex.points[p] = positionOf(complex.origins[p], complex, lattice);
}

}  // namespace sherd
