#pragma once

#include <memory>

#include "bullet/bodies/decided_blow.h"
#include "bullet/strikes/contact_collector.h"

namespace sherd {

// What strikes a body that is held breaks it, and goes on into what its supports still hold of it: they would
// stop a car for good that has just gone through a pane of glass. Where such a rest is light against the
// striker, it comes out of its supports in one piece, since its stress is largest there. Where only what of
// it is in the way is light, as under a ball, it breaks as any body does, and what is left of it is light, or
// comes out if it may not break any further; else it stops what strikes it, whole or broken. Where a step has
// broken as many bodies as the budget lets it, what may go on through the next one tears that out, too, and
// it breaks when it is its turn.

/// Whether a contact may break what supports still hold of a body, although it belongs to the blow that broke
/// the whole: that of something which is not too light to go on, and flies in no cloud of young fragments.
bool goesOnThrough(const Breakable& rest, const btCollisionObject& striker, const Breakable* breakable,
                   double time_s);

/// Whether the body is a fragment that supports hold, which belongs to the blow at `time_s` or may not break
/// any further, and something heavy enough strikes it: that does not break it, but may tear it out.
bool isLightRest(const StruckBreakable& struck, double time_s);

/// Whether it takes more than a trifle of what strikes it; else that has not come to it yet.
bool isInTheWay(const StruckBreakable& light_rest);

/// Whether the body is such a fragment, and what strikes it hard is not too light to go on: there it may be
/// torn out although it would rather break.
bool mayBeTornOut(const StruckBreakable& struck);

/// What comes of that: the same piece, free. Nothing is solved.
std::shared_ptr<DecidedBlow> tornOut(const StruckBreakable& struck);

}  // namespace sherd
