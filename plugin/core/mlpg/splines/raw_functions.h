#pragma once

#include <vector>

#include "core/sampling/cell_parts.h"

namespace sherd {

/// The B-splines on a solid's lattice before any are tied to others. Functions live on parts of cells, not on
/// space: a lattice point carries one function for every connected set of parts in its support, so nothing
/// couples across a gap.
struct RawFunctions {
    int degree;
    std::vector<Eigen::Vector3i> highest_cells;  ///< per function: of its support, with the largest indices
    std::vector<std::vector<int>> supports;      ///< per function: the parts that it differs from zero on
    std::vector<std::vector<int>> of_part;       ///< per part: its (p + 1)^3 functions, x fastest

    RawFunctions(const CellParts& solid, int degree);

    int count() const { return static_cast<int>(supports.size()); }
    int perPart() const { return (degree + 1) * (degree + 1) * (degree + 1); }

    /// From a part's cell to the highest cell of its n-th function.
    Eigen::Vector3i offset(int n) const {
        const int width = degree + 1;
        return {n % width, n / width % width, n / width / width};
    }
};

}  // namespace sherd
