#pragma once

#include <vector>

#include "fracture/fragments.h"

namespace sherd {

/// Marks the pieces below a volume as dropped, but never the largest piece.
void markDropped(double smallest_m3, std::vector<Fragment>& fragments);

}  // namespace sherd
