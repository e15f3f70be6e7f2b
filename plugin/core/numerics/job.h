#pragma once

#include <sherd/executor.h>

#include <atomic>
#include <cfenv>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "core/numerics/stopwatch.h"

namespace sherd {

/// Work that any thread may do, and one does: the first that comes. It throws nothing. It is done with the
/// rounding of the thread that made it, so that it comes to the same wherever it is done.
class Job : public std::enable_shared_from_this<Job> {
  public:
    static std::shared_ptr<Job> make(std::function<void()> work);

    /// Has it done by the executor, if there is one, some time. What that throws is ignored: the job is then
    /// done where it is needed.
    void submit(const Executor& executor);
    /// Does the work here if nobody has begun.
    void doIfFree();
    /// A thread that is at it stops for nothing more, and is helped: this one will wait for it.
    void hurry() { awaited_ = true; }
    /// Returns when the work is done; does it here if nobody has begun.
    void finish();
    bool isDone();
    /// Since a thread began with it, ms; 0: none has.
    double begunFor_ms();
    /// Waits for a thread that is at it, for some milliseconds at most.
    void waitIfBegun(double most_ms);
    /// After `finish`: whether the thread that called it, or `doIfFree` on that thread, did the work.
    bool doneHere() const { return done_by_ == std::this_thread::get_id(); }

  private:
    explicit Job(std::function<void()> work);
    bool begin();
    void run();

    std::function<void()> work_;
    std::fenv_t rounding_;
    std::mutex mutex_;
    std::condition_variable ended_;
    std::atomic<bool> awaited_{false};  // by a thread that has nothing else to do, or soon will
    Stopwatch since_begun_;
    bool begun_ = false, done_ = false;
    std::thread::id done_by_;  // no executor
};

}  // namespace sherd
