#pragma once

#include <array>
#include <vector>

#include "core/sampling/cell_parts.h"

namespace sherd {

/// Links (pairs of parts) for components that are too small to carry functions of their own: each with the
/// nearest part of another component in the cells around. They hang on the solid by faces too small to count,
/// as at a sharp edge; left alone, they would make the equations singular. `links`: what touches through
/// faces. Parts of `cells` are there, their neighbours are not looked at.
std::vector<std::array<int, 2>> sliverLinks(const CellParts& cells,
                                            const std::vector<std::array<int, 2>>& links);

}  // namespace sherd
