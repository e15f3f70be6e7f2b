#pragma once

#include <vector>

#include "core/clustering/crack_tree.h"
#include "core/damage/damage.h"
#include "fracture/blow_stress.h"
#include "fracture/strike_context.h"

namespace sherd {

/// The part of a body that a short contact breaks out of it, as the planes of a prism about its axis, their
/// normals outward; none if cracks may run through all of the body. It reaches as far as a crack runs while
/// the contact drives it, at its terminal speed of 0.38 (E / density)^(1/2) (D. K. Roberts and A. A. Wells,
/// Engineering 178 (1954) 820), and as far as anything is damaged. The rest is most of the body, and hangs
/// together, as a wall does around a hole.
std::vector<CrackPlane> holeOf(const StrikeContext& struck, const Damage& damage, const BlowForces& forces);

}  // namespace sherd
