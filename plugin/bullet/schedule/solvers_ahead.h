#pragma once

#include <sherd/executor.h>

#include <memory>
#include <vector>

#include "bullet/bodies/breakable.h"

namespace sherd {

/// Has stress problems assembled and factored beside the steps, before a blow needs them: that is most of the
/// time that a blow takes on a body that is not prepared. What comes of the blow is the same whoever makes
/// them, and when; without a thread they are made when they are needed.
class SolversAhead {
  public:
    /// Takes those of new fragments that are worth it.
    void addFragments(const std::vector<Breakable*>& fragments, int most, bool may_have_thread);
    /// Takes a body that may be about to be struck, if nothing answers blows on it yet: three kinds of them
    /// in a second, since what flies by, or lands softly, needs none of the memory that it takes.
    void addStruckSoon(const Breakable& body, double time_s, bool may_have_thread);

  private:
    void add(const std::shared_ptr<const BreakableSolid>& solid, bool may_have_thread);

    std::vector<double> struck_soon_s_;  // when the last ones were taken, simulated time
    Executor thread_;                    // none yet
};

}  // namespace sherd
