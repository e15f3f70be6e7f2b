#pragma once

#include <vector>

#include "bullet/bodies/breakable.h"
#include "bullet/island/island_state.h"

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
    /// Speeds of points of two bodies against each other, m/s, at most.
    struct Meeting {
        double along = 0, whole = 0;  // along the normals of a manifold, and in any direction
        btVector3 normal = btVector3(0, 0, 0);
        bool on_sides = false;  // the normals differ
    };
    /// Of a body, all that may strike it.
    struct Strikers {
        bool touches = false;
        double mass_kg = 0, momentum_n_s = 0, energy_j = 0;  // of those that give way
        double stop_m_s = 0, sliding_stop_m_s = 0;           // the fastest meeting with what does not
        btVector3 stop_normal = btVector3(0, 0, 0);          // of the first of these
        bool stops_on_sides = false;                         // their normals differ
    };
    void add(const Breakable& struck, const btCollisionObject& striker, const Meeting& meeting);
    /// Of a manifold, which has a point.
    Meeting fastestMeeting(const btPersistentManifold& manifold) const;

    const BreakableRegistry& breakables_;
    const StepSnapshot& before_;
    double time_step_s_;
    std::vector<Strikers> strikers_;  // by the place in the world's array of objects
};

}  // namespace sherd
