#include "geometry/cutting/crack_planes.h"

#include <Eigen/LU>
#include <cmath>

namespace sherd {

std::optional<double> crackOnEdge(const LabelLattice& lattice, int a, int b) {
    if (lattice.parts[a] == lattice.parts[b]) return {};
    const auto lead = [&](int node) {
        return lattice.cracks->lead(lattice.parts[a], lattice.parts[b], lattice.nodes[node]);
    };
    const double at_a = lead(a), at_b = lead(b);
    if (!(at_a > 0 && at_b < 0)) return {};  // or NaN: no crack parts them
    return at_a / (at_a - at_b);
}

std::optional<Vec3> crackJunction(const LabelLattice& lattice, int a, int b, int c) {
    const int nodes[3] = {a, b, c};
    // Of the three cracks two are the same, or all meet in a line: the barycentric coordinates w of the point
    // satisfy sum_k w_k lead_ij(x_k) = 0 for all pairs, and sum 1.
    Mat3 matrix = Mat3::Zero();
    Vec3 right = Vec3::Zero();
    double size = 0;
    for (int i = 0; i < 3; ++i) {
        const int own = lattice.parts[nodes[i]], next = lattice.parts[nodes[(i + 1) % 3]];
        if (own == next) return {};
        Vec3 row;
        for (int k = 0; k < 3; ++k) row[k] = lattice.cracks->lead(own, next, lattice.nodes[nodes[k]]);
        if (!row.allFinite()) return {};
        matrix += row * row.transpose();
        size += row.squaredNorm();
    }
    matrix += size * Mat3::Ones();
    right.setConstant(size);
    const Eigen::FullPivLU<Mat3> solver(matrix);
    constexpr double least = 1e-9;  // cracks that are parallel do not meet
    if (!(solver.rcond() > least)) return {};
    const Vec3 w = solver.solve(right);
    return Vec3(w[0] * lattice.nodes[a] + w[1] * lattice.nodes[b] + w[2] * lattice.nodes[c]);
}

}  // namespace sherd
