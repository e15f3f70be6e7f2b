#pragma once

#include <string>

#include "geometry/cutting/fragment_surfaces.h"
#include "support/piece_checks.h"

namespace sherd::fragment_support {

/// What is wrong with the pieces of a body: a fault of one of them or of their cracks (see piece_checks.h),
/// volumes that do not add up to a thousandth, or a crack triangle whose partner is not in the piece that is
/// said to lie across. Empty: nothing.
std::string faultOfCut(const TriangleMesh& body, const FragmentSurfaces& cut);

}  // namespace sherd::fragment_support
