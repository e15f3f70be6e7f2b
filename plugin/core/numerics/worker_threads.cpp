#include "core/numerics/worker_threads.h"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <vector>

namespace sherd {

namespace {

class WorkerThreads {
  public:
    WorkerThreads(int count, std::optional<GivesWay> gives_way) {
        try {
            for (int i = 0; i < count; ++i)
                threads_.emplace_back([this, gives_way] {
                    if (gives_way) giveWay(*gives_way);
                    run();
                });
        } catch (const std::system_error&) {
            // No more threads to be had: those that run do all jobs, or the threads that need them.
        }
    }
    ~WorkerThreads() {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            ending_ = true;
        }
        wake_.notify_all();
        const WaitsForAnother waits;
        for (std::thread& thread : threads_) thread.join();
    }
    WorkerThreads(const WorkerThreads&) = delete;
    WorkerThreads& operator=(const WorkerThreads&) = delete;

    void add(std::function<void()> job) {
        if (threads_.empty()) return;
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            jobs_.push_back(std::move(job));
        }
        wake_.notify_one();
    }

  private:
    void run() {
        while (true) {
            std::function<void()> job;
            {
                std::unique_lock<std::mutex> lock(mutex_);
                wake_.wait(lock, [this] { return ending_ || !jobs_.empty(); });
                if (ending_) return;
                job = std::move(jobs_.front());
                jobs_.pop_front();
            }
            const BusyThread busy;
            job();
        }
    }

    std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<std::function<void()>> jobs_;
    bool ending_ = false;
    std::vector<std::thread> threads_;
};

Executor threadsOf(int count, std::optional<GivesWay> gives_way) {
    const int others = std::max(1, static_cast<int>(std::thread::hardware_concurrency())) - 1;
    const auto threads = std::make_shared<WorkerThreads>(count > 0 ? count : others, gives_way);
    return [threads](std::function<void()> job) { threads->add(std::move(job)); };
}

}  // namespace

Executor workerThreads(int count) {
    return threadsOf(count, std::nullopt);
}

Executor patientWorkerThreads(GivesWay to, int count) {
    return threadsOf(count, to);
}

}  // namespace sherd
