#pragma once

#include <atomic>
#include <functional>

namespace sherd {

/// Runs work(0) ... work(count - 1) on the machine's cores. Which thread runs a chunk is left to chance, so a
/// chunk must write only what is its own; then the result does not depend on the number of threads. The first
/// exception that a chunk throws is thrown again here, after all threads have ended.
void forEachChunk(int count, const std::function<void(int)>& work);

/// While one of these lives, `forEachChunk` on its thread runs all chunks there: for work beside which other
/// threads have work of their own.
class OnThisThreadAlone {
  public:
    OnThisThreadAlone() : OnThisThreadAlone(nullptr) {}
    /// Until `over` becomes true: then another thread waits, and its core is free.
    explicit OnThisThreadAlone(const std::atomic<bool>* over);
    ~OnThisThreadAlone();
    OnThisThreadAlone(const OnThisThreadAlone&) = delete;
    OnThisThreadAlone& operator=(const OnThisThreadAlone&) = delete;

    bool isOver() const { return over_ && *over_ && (!outer_ || outer_->isOver()); }
    /// Whether another thread waits.
    bool isAwaited() const { return (over_ && *over_) || (outer_ && outer_->isAwaited()); }

  private:
    const std::atomic<bool>* over_;
    const OnThisThreadAlone* outer_;
};

/// While one of these lives, its thread has work of its own: `forEachChunk` on other threads leaves it a
/// core. Threads that yield to others need none.
class HasOwnWork {
  public:
    HasOwnWork();
    ~HasOwnWork();
    HasOwnWork(const HasOwnWork&) = delete;
    HasOwnWork& operator=(const HasOwnWork&) = delete;

  private:
    bool counts_;
};

/// First item of a chunk when `total` items are split into `count` chunks of nearly equal size.
inline int chunkBegin(int chunk, int count, int total) {
    return static_cast<int>(static_cast<long long>(total) * chunk / count);
}

}  // namespace sherd
