#pragma once

#include "core/mlpg/particle_forms/shape_functions.h"
#include "core/mlpg/rigid_motions.h"

namespace sherd {

/// The rigid motions of a solid in terms of what its particles carry.
RigidMotions particleMotions(const Discretisation& solid, const TrialSpace& space);

}  // namespace sherd
