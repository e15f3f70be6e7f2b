#include "bullet/bodies/event_queue.h"

#include <algorithm>
#include <utility>

namespace sherd {

namespace {

constexpr std::size_t most_events = 1000;

}  // namespace

void EventQueue::push(QueuedEvent event) {
    if (events_.size() < most_events) {
        events_.push_back(std::move(event));
        return;
    }
    ++dropped_;
    if (event.event.outcome == Outcome::dropped) return;
    // In a heap the budget drops hundreds of blows a step: none of these is worth the news of a break.
    const auto is_of_no_weight = [](const QueuedEvent& queued) {
        return queued.event.outcome == Outcome::dropped || queued.event.outcome == Outcome::held;
    };
    auto left_out = std::find_if(events_.begin(), events_.end(), is_of_no_weight);
    if (left_out == events_.end()) {
        if (is_of_no_weight(event)) return;
        left_out = events_.begin();
    }
    if (left_out->broken) released_.push_back(std::move(left_out->broken));
    events_.erase(left_out);
    events_.push_back(std::move(event));
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
