#include "fracture/decide_blow.h"

#include "core/numerics/stopwatch.h"
#include "fracture/can_break.h"
#include "fracture/coarse_look.h"
#include "fracture/pipeline.h"

namespace sherd {

BlowOutcome decideBlow(const BreakableSolid& solid, const Blow& blow, const FractureSettings& fracture,
                       std::uint64_t seed) {
    BlowOutcome out;  // held, by the gate
    out.impulse_n_s = normalImpulse(blow);
    StageTimes before;
    if (timed(before.gate, [&] { return canBreak(solid, blow, fracture); })) {
        std::optional<BlowOutcome> held = coarseLook(solid, blow, fracture, before);
        out = held ? std::move(*held) : strike(solid, blow, fracture, seed);
        out.impulse_n_s = normalImpulse(blow);
    }
    out.ms += before;
    if (fracture.check_with_full_solve && out.level != Level::full)
        checkWithFullSolve(solid, blow, fracture, seed, out);
    return out;
}

void checkWithFullSolve(const BreakableSolid& solid, const Blow& blow, const FractureSettings& fracture,
                        std::uint64_t seed, BlowFigures& decided) {
    const AddedTime time(decided.ms.check);
    FractureSettings in_full = fracture;
    in_full.use_reduced_model = false;
    // A fragment that keeps a factor gets no coarse look at its next blow: the check asks a copy.
    const bool is_looked_at = solid.isFragment() && !solid.prepared();
    const auto copy = is_looked_at ? solid.anchored(solid.supports()) : nullptr;
    const BlowOutcome full = strike(copy ? *copy : solid, blow, in_full, seed);
    decided.full_solve_outcome = full.outcome;
    if (!full.message.empty())
        decided.message += (decided.message.empty() ? "" : " ") + ("The full solve says: " + full.message);
    decided.full_solve_largest_stress_pa = full.largest_stress_pa;
}

}  // namespace sherd
