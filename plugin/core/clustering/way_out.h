#pragma once

#include <sherd/types.h>

#include <vector>

namespace sherd {

/// Whether a part that cracks with these outward unit normals bound can be moved off its neighbours along
/// some direction: one to which none of the cracks faces by more than 10 degrees.
bool hasWayOut(const std::vector<Vec3>& normals);

}  // namespace sherd
