#pragma once

#include <sherd/push.h>

#include <cstdint>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "bullet/bodies/body_token.h"

class btRigidBody;

namespace sherd {

/// What the app asks for, from inside a step or between two: carried out in this order, inside a step at its
/// end.
class AppRequests {
  public:
    struct Removal {
        btRigidBody* body = nullptr;
        BodyToken token = no_token;
    };
    struct Blow {
        std::uint64_t serial = 0;  ///< of the body
        std::vector<Push> pushes;
        int explosion = 0;  ///< its number; 0: the blow stands by itself
    };

    bool empty() const { return removals_.empty() && blows_.empty(); }
    void add(const Removal& removal) { removals_.push_back(removal); }
    void add(Blow blow) { blows_.push_back(std::move(blow)); }
    /// The number of a new explosion.
    int newExplosion() { return ++explosions_; }

    bool isToBeRemoved(BodyToken token) const;
    /// The first of the removals, which is one no longer; none: there is none.
    std::optional<Removal> takeRemoval();
    /// The first blow, or all of its explosion; none: there is none.
    std::vector<Blow> takeBlows();

  private:
    std::deque<Removal> removals_;
    std::deque<Blow> blows_;
    int explosions_ = 0;  // so far
};

}  // namespace sherd
