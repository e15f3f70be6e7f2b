#include "core/numerics/job.h"

#include <chrono>
#include <utility>

#include "core/numerics/parallel_chunks.h"
#include "core/numerics/urgent_work.h"

namespace sherd {

std::shared_ptr<Job> Job::make(std::function<void()> work) {
    return std::shared_ptr<Job>(new Job(std::move(work)));
}

Job::Job(std::function<void()> work) : work_(std::move(work)) {
    std::fegetenv(&rounding_);
}

void Job::submit(const Executor& executor) {
    if (!executor) return;
    try {
        executor([job = shared_from_this()] {
            if (!job->begin()) return;
            const HasOwnWork work;
            const OnThisThreadAlone others_have_work(&job->awaited_);
            job->run();
        });
    } catch (...) {
    }
}

void Job::doIfFree() {
    if (!begin()) return;
    run();
    done_by_ = std::this_thread::get_id();
}

void Job::finish() {
    doIfFree();
    hurry();
    std::unique_lock<std::mutex> lock(mutex_);
    ended_.wait(lock, [this] { return done_; });
}

void Job::waitIfBegun(double most_ms) {
    const WaitsForAnother waits;
    std::unique_lock<std::mutex> lock(mutex_);
    if (begun_)
        ended_.wait_for(lock, std::chrono::duration<double, std::milli>(most_ms), [this] { return done_; });
}

bool Job::isDone() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return done_;
}

double Job::begunFor_ms() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return begun_ ? since_begun_.milliseconds() : 0;
}

bool Job::begin() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (std::exchange(begun_, true)) return false;
    since_begun_ = Stopwatch();
    return true;
}

void Job::run() {
    std::fenv_t own;
    std::fegetenv(&own);
    std::fesetenv(&rounding_);
    std::exchange(work_, nullptr)();
    std::fesetenv(&own);
    // The lock is held while others are told: one that waits may delete the job right after.
    const std::lock_guard<std::mutex> lock(mutex_);
    done_ = true;
    ended_.notify_all();
}

}  // namespace sherd
