#pragma once

#include <cstdint>
#include <optional>

#include "core/loads/blow.h"
#include "fracture/blow_outcome.h"
#include "fracture/breakable_solid.h"

namespace sherd {

// What a blow does is decided by the first level that can (`BlowFigures::level`): `canBreak` asks whether it
// is worth a solve, `coarseLook` whether a fragment withstands it by far, `strike` solves it. What blows
// damaged `earlier` takes part in how the body comes apart, not in whether this blow damages anything: so the
// first two need not know of it.

/// What comes of a blow that `canBreak` says is not worth a solve; nothing for others. What asking took is
/// added to `gate_ms` if it is not in the outcome.
std::optional<BlowOutcome> heldByGate(const BreakableSolid& solid, const Blow& blow,
                                      const FractureSettings& fracture, std::uint64_t seed, double& gate_ms,
                                      const std::shared_ptr<const DamagedMaterial>& earlier = {});

/// What comes of a blow that is worth a solve.
BlowOutcome solveBlow(const BreakableSolid& solid, const Blow& blow, const FractureSettings& fracture,
                      std::uint64_t seed, const std::shared_ptr<const DamagedMaterial>& earlier = {});

/// Notes in the figures of a decided blow what a full solve says of it, and what asking took. Of the solid it
/// changes only what is made once and kept.
void checkWithFullSolve(const BreakableSolid& solid, const Blow& blow, const FractureSettings& fracture,
                        std::uint64_t seed, BlowFigures& decided,
                        const std::shared_ptr<const DamagedMaterial>& earlier = {});

}  // namespace sherd
