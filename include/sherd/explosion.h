#pragma once

#include <LinearMath/btVector3.h>
#include <sherd/result.h>

namespace sherd {

class FractureWorld;

/// An explosion, by what a game wants of it: a push that falls with the square of the distance.
struct Explosion {
    btVector3 centre = btVector3(0, 0, 0);  ///< m
    /// Sent out evenly in all directions, all together: 1 m away a cup or a held pane breaks at 500 and is in
    /// many pieces at 1500, a brick wall of 12 cm breaks at 5000 to 10,000 from 1.5 m.
    double impulse_n_s = 0;
    double reach_m = 0;  ///< surface further away than this is left alone
};

/// Strikes every breakable body around the centre (FractureWorld::applyBlow): each triangle that faces the
/// centre is pushed away from it, with the share of the impulse that its solid angle has of the sphere,
/// joined to one push an octant about the push on all of the body. A centre on a surface counts as outside,
/// one inside a body acts where that body's surface is nearest. Bodies do not shield each other, nor what
/// lies behind in the same body, and other bodies than breakable ones are left alone: push them yourself. Up
/// to `Budget::solves_per_step` whole or held bodies break in the call (inside a step: at its end). Of more
/// of them the one that is struck hardest does, and each other one when it is its turn, where it is by then,
/// `Budget::longest_wait_s` later at most (half as long again for each explosion just before): none is
/// dropped for want of time. Blows on other fragments wait too, and may be dropped, though they are pushed.
/// Returns how many were struck; the error says which figure is out of range.
Result<int> explode(FractureWorld& world, const Explosion& explosion);

}  // namespace sherd
