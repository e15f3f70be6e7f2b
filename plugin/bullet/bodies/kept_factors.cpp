#include "bullet/bodies/kept_factors.h"

#include <algorithm>

#include "fracture/breakable_solid.h"

namespace sherd {

bool keepsFactorForAWhile(const BreakableSolid& solid) {
    // Not `isFactored`: of a body that is about to be struck again a thread may make it at any time.
    return solid.isFragment() && !solid.expectsFactor() && !solid.prepared();
}

void KeptFactors::noteDecided(const Breakable& body, const BreakableRegistry& breakables) {
    constexpr std::size_t most_kept = 2;
    if (!keepsFactorForAWhile(*body.asset.solid())) return;
    const auto bodyOf = [&](std::uint64_t serial) {
        const auto& all = breakables.all();
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const auto& other) { return other->serial == serial; });
        return found == all.end() ? nullptr : found->get();
    };
    const auto is_over = [&](std::uint64_t serial) { return serial == body.serial || !bodyOf(serial); };
    serials_.erase(std::remove_if(serials_.begin(), serials_.end(), is_over), serials_.end());
    serials_.push_back(body.serial);
    if (serials_.size() <= most_kept) return;
    BreakableAsset& oldest = bodyOf(serials_.front())->asset;
    serials_.pop_front();
    // Who else holds the solid, as a thread that is at a blow on it, keeps what it has.
    if (keepsFactorForAWhile(*oldest.solid())) oldest = BreakableAsset(oldest.solid()->unsolved());
}

}  // namespace sherd
