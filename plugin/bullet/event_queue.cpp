#include "bullet/event_queue.h"

#include <utility>

namespace sherd {

namespace {

constexpr std::size_t most_events = 1000;

}  // namespace

void EventQueue::push(QueuedEvent event) {
    events_.push_back(std::move(event));
    if (events_.size() <= most_events) return;
    if (events_.front().broken) released_.push_back(std::move(events_.front().broken));
    events_.pop_front();
    ++dropped_;
}

std::vector<BlowEvent> EventQueue::take(bool inside_step) {
    auto& released = inside_step ? released_inside_step_ : released_;
    std::vector<BlowEvent> taken;
    taken.reserve(events_.size());
    for (QueuedEvent& queued : events_) {
        taken.push_back(std::move(queued.event));
        if (queued.broken) released.push_back(std::move(queued.broken));
    }
    events_.clear();
    return taken;
}

void EventQueue::deleteReleased() {
    released_ = std::exchange(released_inside_step_, {});
}

}  // namespace sherd
