#pragma once

#include "core/linear_algebra/block_matrix.h"
#include "core/mlpg/splines/volumetric_projection.h"

namespace sherd {

/// Which unknown functions share a part, and so have a block of 3 x 3 in the stiffness.
struct StiffnessPattern {
    std::vector<std::vector<int>> functions_of_part;        ///< that reach it, ascending
    std::vector<std::vector<int>> functions_of_macro_cell;  ///< the same
    std::vector<std::vector<int>> rows_of_column;           ///< block rows from the diagonal down, ascending

    /// Those of a macro cell share it, too.
    explicit StiffnessPattern(const SplineSpace& space, const VolumetricProjection* projection = nullptr);
};

/// The blocks of 3 x 3 of that pattern, without values.
BlockMatrix emptyMatrixOf(const StiffnessPattern& pattern);

}  // namespace sherd
