#pragma once

#include <cstddef>
#include <vector>

#include "core/linear_algebra/block_matrix.h"
#include "core/mlpg/rigid_motions.h"

namespace sherd {

/// For each component up to six unknowns far apart; holding them at zero leaves no rigid motion (pivoted
/// Gram-Schmidt on the rows of `coefficients`). Fewer than six where the unknowns cannot express all six
/// motions. Stiff ones are taken: a body that is held where it is soft sways as a whole,
/// and its equations are a thousand times worse conditioned.
std::vector<int> unknownsToPin(const RigidMotions& motions, const BlockMatrix& stiffness);

struct ReplacedValue {
    std::size_t index;  ///< into the values of the matrix
    double value;       ///< as it was
};

/// Holds unknowns at zero: their rows and columns vanish but for a positive diagonal. Returns the values that
/// were there.
std::vector<ReplacedValue> pinUnknowns(BlockMatrix& matrix, const std::vector<int>& unknowns);

}  // namespace sherd
