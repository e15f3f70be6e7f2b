#pragma once

#include <sherd/sherd.h>

#include <atomic>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include "prototype/level.h"

namespace prototype {

/// A level whose things can break at once.
struct ReadyLevel {
    Level level;
    std::vector<sherd::BreakableAsset> assets;  ///< one for each kind
    int baked = 0;                              ///< of these, were not in the folder yet
};

/// Gets a level ready on a thread of its own. What takes seconds is kept in a folder, one file for each kind;
/// a file that is missing, unreadable or of a kind that has changed since is made anew.
class Baking {
  public:
    explicit Baking(const std::string& folder);

    bool done() const;
    float share() const { return *share_; }                     ///< from 0 to 1
    sherd::Result<ReadyLevel> take() { return future_.get(); }  ///< waits for the end

  private:
    std::shared_ptr<std::atomic<float>> share_ = std::make_shared<std::atomic<float>>(0.0f);
    std::future<sherd::Result<ReadyLevel>> future_;
};

}  // namespace prototype
