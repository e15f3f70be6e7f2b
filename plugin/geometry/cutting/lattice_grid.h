#pragma once

#include <sherd/types.h>

namespace sherd {

constexpr int lattice_margin = 3;  ///< cells of air around the solid's box

/// Where the nodes of a cubic lattice are, before they are jittered. Node (i, j, k) has index i + size.x (j +
/// size.y k); cell (i, j, k) has the index of its lowest node.
struct LatticeGrid {
    double spacing = 0;  ///< m
    double jitter = 0;   ///< by how much nodes are moved at most along each axis, of the spacing
    Vec3 origin = Vec3::Zero();
    Eigen::Vector3i size = Eigen::Vector3i::Zero();  ///< nodes along each axis

    std::size_t nodeCount() const { return static_cast<std::size_t>(size.cast<double>().prod()); }
    int index(int i, int j, int k) const { return i + size.x() * (j + size.y() * k); }

    /// Calls visit(i, j, k) for every cell.
    template <class Visit>
    void forEachCell(const Visit& visit) const {
        for (int k = 0; k + 1 < size.z(); ++k)
            for (int j = 0; j + 1 < size.y(); ++j)
                for (int i = 0; i + 1 < size.x(); ++i) visit(i, j, k);
    }

    /// From the index of a cell to that of its corner 0 ... 7.
    int stepToCorner(int corner) const { return index(corner % 2, corner / 2 % 2, corner / 4); }
};

}  // namespace sherd
