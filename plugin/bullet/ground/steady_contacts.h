#pragma once

#include <functional>
#include <vector>

#include "bullet/bodies/breakable.h"
#include "bullet/ground/moved_ground.h"

class btDiscreteDynamicsWorld;

namespace sherd {

class BirthOverlaps;

/// What of the bodies of a world matters to their contacts.
struct SteadiedBodies {
    const BreakableRegistry& breakables;
    const BirthOverlaps& overlaps;
    std::function<bool(const btCollisionObject&)> is_fragment;  ///< of any FractureWorld of the world
    const MovedSurfaces& moved_ground;                          ///< since the step before
};

/// Makes the contacts of fragments such that they come to rest, and those of whole bodies with shapes of
/// Sherd's that fall or tumble such that they do not sink into the ground. Splinters are small for what
/// they move in a step. Bullet finds one vertex of a hull a step, when it is in the floor already, and takes
/// a fifth of the depth back in each, as a velocity that stays: a splinter that rocks on its vertices is
/// thrown up again and again, and one that has flown into the floor by more than its own size spins. So
/// vertices that a manifold with the body below lacks, and that may be in that by the end of the step, are
/// added to it: the solver stops them there. The body below is what stands still, what the app moves, or what
/// is no fragment and no lighter. Impulses of an impact are not begun with in the next step.
/// And deep contacts count as less deep, such that nothing is pushed out of a fragment, or a fragment out of
/// anything, at more than 0.05 m/s, but where the solver moves it out of a solid below without a velocity.
/// What lies in a hollow body and may overlap it (`overlaps`) is left as it is. For just before a solve.
/// `is_concerned`: of a pair at least one body has to be, for what the solve was prepared for before; extra
/// manifolds of a pair are made once.
void steadyContacts(btDiscreteDynamicsWorld& world, const SteadiedBodies& bodies,
                    const std::function<bool(const btCollisionObject&)>& is_concerned);

}  // namespace sherd
