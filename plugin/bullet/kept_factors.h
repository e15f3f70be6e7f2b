#pragma once

#include <cstdint>
#include <deque>

#include "bullet/breakable.h"

namespace sherd {

/// Fragments that held keep their stress problem for the next blow, a few megabytes each: those do that were
/// struck last. Of the others it is made anew, should they be struck again. Which these are follows from the
/// blows alone, never from the clock.
class KeptFactors {
  public:
    /// For a blow that a body held and that was solved in full.
    void noteHeld(const Breakable& body, const BreakableRegistry& breakables);

  private:
    std::deque<std::uint64_t> serials_;  // the last one last
};

}  // namespace sherd
