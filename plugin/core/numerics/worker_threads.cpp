#include <sherd/executor.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace sherd {

namespace {

/// What a stress problem is made with is ten times as large as what is kept of it, and a thread's heap would
/// keep all of it for the next one.
void returnFreeMemory() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

class WorkerThreads {
  public:
    explicit WorkerThreads(int count) {
        try {
            for (int i = 0; i < count; ++i) threads_.emplace_back([this] { run(); });
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
        constexpr std::chrono::milliseconds idle{100};
        const auto has_work = [this] { return ending_ || !jobs_.empty(); };
        for (bool has_worked = false;; has_worked = true) {
            std::function<void()> job;
            {
                std::unique_lock<std::mutex> lock(mutex_);
                if (has_worked && !wake_.wait_for(lock, idle, has_work)) {
                    lock.unlock();
                    returnFreeMemory();
                    lock.lock();
                }
                wake_.wait(lock, has_work);
                if (ending_) return;
                job = std::move(jobs_.front());
                jobs_.pop_front();
            }
            job();
        }
    }

    std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<std::function<void()>> jobs_;
    bool ending_ = false;
    std::vector<std::thread> threads_;
};

}  // namespace

Executor workerThreads(int count) {
    const int others = std::max(1, static_cast<int>(std::thread::hardware_concurrency())) - 1;
    const auto threads = std::make_shared<WorkerThreads>(count > 0 ? count : others);
    return [threads](std::function<void()> job) { threads->add(std::move(job)); };
}

}  // namespace sherd
