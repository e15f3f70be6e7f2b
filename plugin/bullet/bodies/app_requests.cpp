#include "bullet/bodies/app_requests.h"

#include <algorithm>
#include <utility>

namespace sherd {

bool AppRequests::isToBeRemoved(BodyToken token) const {
    return std::any_of(removals_.begin(), removals_.end(),
                       [&](const Removal& removal) { return removal.token == token; });
}

std::optional<AppRequests::Removal> AppRequests::takeRemoval() {
    if (removals_.empty()) return std::nullopt;
    const Removal first = removals_.front();
    removals_.pop_front();
    return first;
}

std::vector<AppRequests::Blow> AppRequests::takeBlows() {
    std::vector<Blow> together;
    const auto belongs = [&](const Blow& next) {
        return together.empty() || (next.explosion > 0 && next.explosion == together.back().explosion);
    };
    while (!blows_.empty() && belongs(blows_.front())) {
        together.push_back(std::move(blows_.front()));
        blows_.pop_front();
    }
    return together;
}

}  // namespace sherd
