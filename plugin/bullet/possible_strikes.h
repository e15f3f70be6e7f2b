#pragma once

#include <vector>

#include "bullet/breakable.h"
#include "bullet/island_state.h"

namespace sherd {

/// Which breakable bodies the contacts of a step may bring the energy that breaks them, at most, wherever
/// their points are. Those of the others, bodies that rest or roll, are not looked at.
class PossibleStrikes {
  public:
    PossibleStrikes(const BreakableRegistry& breakables, const StepSnapshot& before, double time_step_s)
        : breakables_(breakables), before_(before), time_step_s_(time_step_s) {}

    /// Counts in what the two bodies of a manifold, both in the world, may bring each other.
    void add(const btPersistentManifold& manifold);
    /// Whether all that was counted in may break a body.
    bool mayBreak(const Breakable& breakable) const;

  private:
    void add(const Breakable& struck, const btCollisionObject& striker, double speed_m_s);
    /// Of points of the two bodies along the normals of a manifold, which has one, m/s, at most.
    double fastestMeeting(const btPersistentManifold& manifold) const;

    const BreakableRegistry& breakables_;
    const StepSnapshot& before_;
    double time_step_s_;
    std::vector<double> energy_j_;  // by the place in the world's array of objects
};

}  // namespace sherd
