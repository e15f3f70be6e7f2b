#include "bullet/kept_factors.h"

#include <algorithm>

#include "fracture/breakable_solid.h"

namespace sherd {

namespace {

constexpr std::size_t most_kept = 2;

/// Others have theirs for good: the app has prepared them, or they count with `Budget::prepared_fragments`.
/// Whether a thread has made it by now does not count.
bool isKeptForAWhile(const Breakable& body) {
    const BreakableSolid& solid = *body.asset.solid();
    return body.isFragment() && !solid.expectsFactor() && !solid.prepared();
}

}  // namespace

void KeptFactors::noteHeld(const Breakable& body, const BreakableRegistry& breakables) {
    if (!isKeptForAWhile(body)) return;
    serials_.erase(std::remove(serials_.begin(), serials_.end(), body.serial), serials_.end());
    serials_.push_back(body.serial);
    if (serials_.size() <= most_kept) return;
    const std::uint64_t oldest = serials_.front();
    serials_.pop_front();
    for (const auto& other : breakables.all())
        // What others still hold of the solid, a thread that is at a blow on it too, goes with them.
        if (other->serial == oldest && isKeptForAWhile(*other))
            other->asset = BreakableAsset(other->asset.solid()->unsolved());
}

}  // namespace sherd
