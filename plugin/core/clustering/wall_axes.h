#pragma once

#include <vector>

#include "core/sampling/discretisation.h"

namespace sherd {

/// Per particle the unit normal of the wall that it lies in, of either sign: the direction that most of the
/// surface in and around its sub-domain faces. Zero where the surface faces several ways, as at rims and
/// corners, and deep inside a compact body.
std::vector<Vec3> wallAxes(const Discretisation& solid);

}  // namespace sherd
