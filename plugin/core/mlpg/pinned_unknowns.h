#pragma once

#include <vector>

#include "core/linear_algebra/sparse_matrix.h"
#include "core/mlpg/rigid_motions.h"

namespace sherd {

/// For each component up to six unknowns far apart; holding them at zero leaves no rigid motion (pivoted
/// Gram-Schmidt on the rows of `coefficients`). Fewer than six where the unknowns cannot express all six
/// motions. Stiff ones are taken (`stiffness` in CSC): a body that is held where it is soft sways as a whole,
/// and its equations are a thousand times worse conditioned.
std::vector<int> unknownsToPin(const RigidMotions& motions, const SparseMatrix& stiffness);

struct ReplacedValue {
    int index;     ///< into the values of the matrix
    double value;  ///< as it was
};

/// Holds unknowns of a symmetric matrix (CSC, lower half) at zero: their rows and columns vanish but for a
/// positive diagonal. Returns the values that were there.
std::vector<ReplacedValue> pinUnknowns(SparseMatrix& lower, const std::vector<int>& unknowns);

}  // namespace sherd
