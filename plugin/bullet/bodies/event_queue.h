#pragma once

#include <sherd/events.h>

#include <deque>
#include <memory>
#include <vector>

#include "bullet/bodies/breakable.h"

namespace sherd {

/// An event with the body that broke in it, if one did. The body is kept alive for the app to read.
struct QueuedEvent {
    BlowEvent event;
    std::unique_ptr<Breakable> broken = nullptr;
};

/// The events that the app has not taken yet, in order. Holds a limited number: beyond that those of blows
/// that the budget dropped are left out, then the oldest that held, then the oldest.
class EventQueue {
  public:
    void push(QueuedEvent event);
    /// `inside_step`: the app is called from inside a step, in which a solve may still begin.
    std::vector<BlowEvent> take(bool inside_step = false);
    long long dropped() const { return dropped_; }

    /// Deletes the broken bodies whose events were taken before this step, or dropped. For the start of a
    /// solve: by then no contact of an earlier step points to them.
    void deleteReleased();
    bool hasReleased() const { return !released_.empty() || !released_inside_step_.empty(); }

  private:
    std::deque<QueuedEvent> events_;
    std::vector<std::unique_ptr<Breakable>> released_, released_inside_step_;
    long long dropped_ = 0;
};

}  // namespace sherd
