#include "geometry/cutting/active_cells.h"

#include <array>

namespace sherd {

namespace {

enum : char { outside = 0, unreached = 1, near_surface = 2 };

// In cells. Jitter and smoothing move a crack out of its cell by less, and all cells around the node nearest
// to a surface point are marked.
constexpr double margin = 0.8;

void markNearSurface(const TriangleMesh& surface, const LatticeGrid& lattice, std::vector<char>& state) {
    Eigen::Vector3i marked_first(-1, -1, -1), marked_last = marked_first;
    for (const auto& t : surface.triangles) {
        const Vec3 &a = surface.vertices[t[0]], &b = surface.vertices[t[1]], &c = surface.vertices[t[2]];
        const Vec3 low =
            (a.cwiseMin(b).cwiseMin(c) - lattice.origin) / lattice.spacing - Vec3::Constant(margin);
        const Vec3 high =
            (a.cwiseMax(b).cwiseMax(c) - lattice.origin) / lattice.spacing + Vec3::Constant(margin);
        // The lattice begins in the air below the solid, so all of this is positive and truncation rounds
        // down.
        const Eigen::Vector3i first = low.cast<int>();
        const Eigen::Vector3i last = high.cast<int>().cwiseMin((lattice.size.array() - 2).matrix());
        // The neighbours of a small triangle come soon after it, and often mean the same cells.
        if (first == marked_first && last == marked_last) continue;
        marked_first = first;
        marked_last = last;
        for (int k = first.z(); k <= last.z(); ++k)
            for (int j = first.y(); j <= last.y(); ++j)
                for (int i = first.x(); i <= last.x(); ++i) state[lattice.index(i, j, k)] = near_surface;
    }
}

// The outermost layer of cells is outside by construction, so a flood from one corner reaches all of the
// outside.
void floodOutside(const LatticeGrid& lattice, std::vector<char>& state) {
    std::vector<std::array<int, 3>> front = {{0, 0, 0}};
    state[0] = outside;
    while (!front.empty()) {
        const auto cell = front.back();
        front.pop_back();
        for (int side = 0; side < 6; ++side) {
            auto next = cell;
            next[side / 2] += side % 2 ? 1 : -1;
            if (next[side / 2] < 0 || next[side / 2] > lattice.size[side / 2] - 2) continue;
            char& reached = state[lattice.index(next[0], next[1], next[2])];
            if (reached != unreached) continue;
            reached = outside;
            front.push_back(next);
        }
    }
}

}  // namespace

std::vector<int> findActiveCells(const TriangleMesh& surface, const LatticeGrid& lattice) {
    std::vector<char> state(lattice.nodeCount(), outside);
    lattice.forEachCell([&](int i, int j, int k) { state[lattice.index(i, j, k)] = unreached; });
    markNearSurface(surface, lattice, state);
    floodOutside(lattice, state);
    std::vector<int> active;
    for (std::size_t cell = 0; cell < state.size(); ++cell)
        if (state[cell] != outside) active.push_back(static_cast<int>(cell));
    return active;
}

}  // namespace sherd
