#pragma once

#include <memory>

#include "bullet/contact_collector.h"
#include "bullet/decided_blow.h"

namespace sherd {

// What strikes a body that is held breaks it, and goes on into what its supports still hold: they would stop
// a car for good that has just gone through a pane of glass. Where such a rest is light against the striker,
// it comes out of its supports in one piece, since its stress is largest there; a heavier one breaks as any
// body does, and what is left of it is light.

/// Whether a blow that the gate lets through tears the body out of its supports: a fragment that they hold,
/// which belongs to the blow at `time_s` or may not break any further, struck by something heavy.
bool isTornOut(const StruckBreakable& struck, double time_s);

/// What comes of that: the same piece, free. Nothing is solved.
std::shared_ptr<DecidedBlow> tornOut(const StruckBreakable& struck);

}  // namespace sherd
