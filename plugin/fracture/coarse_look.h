#pragma once

#include "core/loads/blow.h"
#include "fracture/blow_outcome.h"
#include "fracture/breakable_solid.h"

namespace sherd {

/// A first look at a blow on a fragment that is neither factored nor prepared
/// (`BreakableSolid::makeCoarseModel`): the held blow if what the fragment stores of it pays for no crack, by
/// a margin that is wider than the coarse model's error was ever seen to be; none if only a full solve can
/// tell, or if the settings ask for one that the model was not compared with (other trial functions than
/// splines, cubic ones). Adds what it took to `ms.coarse`.
std::optional<BlowOutcome> coarseLook(const BreakableSolid& solid, const Blow& blow,
                                      const FractureSettings& fracture, StageTimes& ms);

}  // namespace sherd
