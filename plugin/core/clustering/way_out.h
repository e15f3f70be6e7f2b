#pragma once

#include <sherd/types.h>

#include <vector>

namespace sherd {

/// Sine of the angle by which a crack may face the way out, 10 degrees.
constexpr double most_facing = 0.1736;

/// Whether a part that cracks with these outward unit normals bound can be moved off its neighbours along
/// some direction: one to which none of the cracks faces by more than that.
bool hasWayOut(const std::vector<Vec3>& normals);

}  // namespace sherd
