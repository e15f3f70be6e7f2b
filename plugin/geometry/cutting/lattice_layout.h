#pragma once

#include <sherd/triangle_mesh.h>

#include <vector>

#include "core/sampling/discretisation.h"
#include "geometry/cutting/lattice_grid.h"

namespace sherd {

/// What a lattice over a solid is before its fragments are known: it serves every cut at that spacing.
struct LatticeLayout {
    LatticeGrid grid;
    std::vector<int> active_cells;    ///< ascending; those that the solid may reach into
    std::vector<int> first_triangle;  ///< #active_cells + 1, offsets into `triangles`
    std::vector<int> triangles;       ///< of the body's surface, that cracks in each cell may meet, ascending
    std::vector<int> nodes;           ///< ascending; those of active cells, which get a label
    std::vector<int> first_particle;  ///< #nodes + 1, offsets into `particles`
    std::vector<int> particles;       ///< whose kernels may reach each node, ascending
};

LatticeLayout layLattice(const TriangleMesh& surface, const Discretisation& solid, double spacing_m);

}  // namespace sherd
