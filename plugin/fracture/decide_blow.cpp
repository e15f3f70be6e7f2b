#include "fracture/decide_blow.h"

#include "core/numerics/pi.h"
#include "core/numerics/stopwatch.h"
#include "fracture/add_sentence.h"
#include "fracture/can_break.h"
#include "fracture/coarse_look.h"
#include "fracture/pipeline.h"

namespace sherd {

namespace {

/// The figures that do not depend on what decided, and the check by a full solve if that is asked for.
BlowOutcome completed(BlowOutcome out, const BreakableSolid& solid, const Blow& blow,
                      const FractureSettings& fracture, std::uint64_t seed,
                      const std::shared_ptr<const DamagedMaterial>& earlier) {
    out.impulse_n_s = normalImpulse(blow);
    if (!(out.impulse_n_s > 0)) out.impulse_n_s = 2 / pi * out.peak_force_n * out.contact_time_s;
    if (fracture.check_with_full_solve && out.level != Level::full)
        checkWithFullSolve(solid, blow, fracture, seed, out, earlier);
    return out;
}

}  // namespace

std::optional<BlowOutcome> heldByGate(const BreakableSolid& solid, const Blow& blow,
                                      const FractureSettings& fracture, std::uint64_t seed, double& gate_ms,
                                      const std::shared_ptr<const DamagedMaterial>& earlier) {
    BlowOutcome held;
    held.level = Level::gate;
    if (timed(held.ms.gate, [&] { return canBreak(solid, blow, fracture); })) {
        gate_ms += held.ms.gate;
        return std::nullopt;
    }
    return completed(std::move(held), solid, blow, fracture, seed, earlier);
}

BlowOutcome solveBlow(const BreakableSolid& solid, const Blow& blow, const FractureSettings& fracture,
                      std::uint64_t seed, const std::shared_ptr<const DamagedMaterial>& earlier) {
    StageTimes before;
    std::optional<BlowOutcome> held = coarseLook(solid, blow, fracture, before);
    BlowOutcome out = held ? std::move(*held) : strike(solid, blow, fracture, seed, earlier);
    out.ms += before;
    return completed(std::move(out), solid, blow, fracture, seed, earlier);
}

void checkWithFullSolve(const BreakableSolid& solid, const Blow& blow, const FractureSettings& fracture,
                        std::uint64_t seed, BlowFigures& decided,
                        const std::shared_ptr<const DamagedMaterial>& earlier) {
    const AddedTime time(decided.ms.check);
    FractureSettings in_full = fracture;
    in_full.use_reduced_model = false;
    // A fragment that keeps a factor gets no coarse look at its next blow: the check asks a copy.
    const bool is_looked_at = solid.isFragment() && !solid.hasSolver();
    const auto copy = is_looked_at ? solid.unsolved() : nullptr;
    const BlowOutcome full = strike(copy ? *copy : solid, blow, in_full, seed, earlier);
    decided.full_solve_outcome = full.outcome;
    if (!full.message.empty()) addSentence(decided.message, "The full solve says: " + full.message);
    decided.full_solve_largest_stress_pa = full.largest_stress_pa;
}

}  // namespace sherd
