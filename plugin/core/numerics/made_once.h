#pragma once

#include <atomic>
#include <mutex>
#include <optional>

#include "core/numerics/urgent_work.h"

namespace sherd {

/// A value that is made when it is first asked for, and never changes then. A thread that asks for it while
/// another makes it waits for that one; `ifMade` never waits.
template <class T>
class MadeOnce {
  public:
    /// The value, from `make` if it is not there yet. What `make` throws goes to the caller, and the next one
    /// makes it anew.
    template <class Make>
    const T& get(const Make& make) {
        if (const T* made = ifMade()) return *made;
        std::unique_lock<std::mutex> lock(making_, std::try_to_lock);
        if (!lock) {
            const WaitsForAnother waits;
            lock.lock();
        }
        if (!value_) {
            value_.emplace(make());
            made_.store(&*value_, std::memory_order_release);
        }
        return *value_;
    }

    /// nullptr until it is made.
    const T* ifMade() const { return made_.load(std::memory_order_acquire); }

  private:
    std::mutex making_;
    std::optional<T> value_;
    std::atomic<const T*> made_{nullptr};
};

}  // namespace sherd
