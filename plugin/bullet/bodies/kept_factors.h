#pragma once

#include <cstdint>
#include <deque>

#include "bullet/bodies/breakable.h"

namespace sherd {

/// Fragments keep their factored stress problem for the next blow, a few megabytes each: those do whose blows
/// were decided last. Of the others it is made anew, should they be struck again. Which these are follows
/// from the blows alone, never from the clock.
class KeptFactors {
  public:
    /// For a blow that more than the gate has decided, and that has not broken its body.
    void noteDecided(const Breakable& body, const BreakableRegistry& breakables);

  private:
    std::deque<std::uint64_t> serials_;  // the last one last
};

/// Whether the stress problem of a body is one of those. Others have theirs for good: of a whole body it
/// serves all that are alike, the app has prepared it, or it counts with `Budget::prepared_fragments`.
bool keepsFactorForAWhile(const BreakableSolid& solid);

}  // namespace sherd
