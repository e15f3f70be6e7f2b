#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "bullet/bodies/body_token.h"
#include "bullet/bodies/decided_blow.h"
#include "bullet/strikes/contact_collector.h"
#include "bullet/world/simulated_time.h"

namespace sherd {

/// A blow that a rehearsal has found.
struct ForeseenBlow {
    std::uint64_t serial = 0;                 ///< of the body that will be struck
    BodyToken mover = no_token;               ///< whose way was rehearsed
    double found_at_s = 0, strikes_at_s = 0;  ///< simulated time
    /// When the one worker is done with it, as the budget has it, and for how long it is at it; simulated
    /// time.
    double solved_by_s = 0, turn_s = 0;
    std::vector<BodyToken> partners;
    BlowToDecide blow;
    std::shared_ptr<DecidedBlow> decided;
    bool is_solved_in_full = false;

    bool isSolvedInTime() const { return solved_by_s <= strikes_at_s + time_rounding_s; }
};

/// Whether a blow is the foreseen one, so that the same comes of it: the same strikes by the same bodies, as
/// far as matters, on a body that rests on the same others, and about there. False for pushes of the app's.
bool isAsForeseen(const ForeseenBlow& foreseen, const StruckBreakable& struck, const BlowToDecide& blow);

}  // namespace sherd
