#pragma once

#include <cstdint>

#include "core/loads/blow.h"
#include "fracture/blow_outcome.h"
#include "fracture/breakable_solid.h"

namespace sherd {

/// What a blow does, decided by the first level that can (`BlowFigures::level`): `canBreak` asks whether it
/// is worth a solve, `coarseLook` whether a fragment withstands it by far, `strike` solves it.
BlowOutcome decideBlow(const BreakableSolid& solid, const Blow& blow, const FractureSettings& fracture,
                       std::uint64_t seed);

/// Notes in the figures of a decided blow what a full solve says of it, and what asking took. Of the solid it
/// changes only what is made once and kept.
void checkWithFullSolve(const BreakableSolid& solid, const Blow& blow, const FractureSettings& fracture,
                        std::uint64_t seed, BlowFigures& decided);

}  // namespace sherd
