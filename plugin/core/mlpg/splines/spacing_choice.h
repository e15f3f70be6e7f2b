#pragma once

#include <sherd/result.h>
#include <sherd/triangle_mesh.h>

namespace sherd {

/// What a particle spacing is to fulfil.
struct SpacingWish {
    double finest_m = 0;  ///< a finer spacing gains nothing
    double wall_m = 0;    ///< thickness of the walls
    int spline_degree = 2;
    double largest_factor_entries = 0;
    double largest_if_thin = 0;  ///< the same where walls would get less than one cell across otherwise
};

/// The finest spacing from `finest_m` up whose stiffness matrix has a factor of no more than the wanted
/// number of stored entries, found by ordering and symbolic factorisation alone.
Result<double> chooseSpacing(const TriangleMesh& surface, const SpacingWish& wish, int cells_per_spacing);

}  // namespace sherd
