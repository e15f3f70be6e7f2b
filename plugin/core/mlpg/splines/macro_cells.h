#pragma once

#include <vector>

#include "core/sampling/cell_parts.h"

namespace sherd {

/// Blocks of `width`^3 cells of a solid's grid, as the sets of parts that are connected inside them. One that
/// holds little of the solid goes with the neighbour that it touches most. #macro cells, parts ascending.
std::vector<std::vector<int>> macroCells(const CellParts& solid, int width);

}  // namespace sherd
