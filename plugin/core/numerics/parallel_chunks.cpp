#include "core/numerics/parallel_chunks.h"

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <list>
#include <mutex>
#include <thread>

#include "core/numerics/stopwatch.h"
#include "core/numerics/thread_priority.h"
#include "core/numerics/urgent_work.h"

namespace sherd {

namespace {

thread_local const OnThisThreadAlone* alone = nullptr;  // the innermost there is

std::atomic<int> with_own_work{0};  // threads
thread_local int own_work = 0;      // of these, whether this is one

/// Chunks that are shared out; it lives on the stack of the thread that asked for them.
class SharedWork {
  public:
    SharedWork(int count, const std::function<void(int)>& work) : count_(count), work_(work) {
        std::fegetenv(&rounding_);
    }

    /// `help` on another thread, which takes the mode of floating-point numbers of the one that asks.
    void helpFromOutside() {
        std::fenv_t own;
        std::fegetenv(&own);
        std::fesetenv(&rounding_);
        help();
        std::fesetenv(&own);
    }

    /// Does chunks until none is left.
    void help() {
        try {
            for (int chunk; (chunk = next_++) < count_;) work_(chunk);
        } catch (...) {
            const std::lock_guard<std::mutex> lock(trouble_mutex_);
            if (!trouble_) trouble_ = std::current_exception();
            next_ = count_;
        }
    }
    void throwTrouble() const {
        if (trouble_) std::rethrow_exception(trouble_);
    }

    int wanted = 0, helping = 0;  ///< of the helpers; theirs

  private:
    int count_;
    const std::function<void(int)>& work_;
    std::fenv_t rounding_;
    std::atomic<int> next_{0};
    std::exception_ptr trouble_;
    std::mutex trouble_mutex_;
};

/// Threads that wait for chunks, one less than the machine has cores: starting a thread for each piece of
/// work takes longer than many of them. They end with the program.
class Helpers {
  public:
    /// Those for what the calling thread asks for: threads that yield have helpers that do.
    static Helpers& ofThisThread() {
        // Never destroyed: their threads run until the program ends.
        if (yieldsToOtherThreads()) {
            static Helpers& yielding = *new Helpers(true);
            return yielding;
        }
        static Helpers& helpers = *new Helpers(false);
        return helpers;
    }

    int count() const { return static_cast<int>(started_); }

    /// Does all chunks, together with the helpers that are free.
    void run(SharedWork& work, int wanted) {
        std::list<SharedWork*>::iterator place;
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            work.wanted = wanted;
            place = open_.insert(open_.end(), &work);
        }
        wanted == 1 ? wake_.notify_one() : wake_.notify_all();
        work.help();
        std::unique_lock<std::mutex> lock(mutex_);
        open_.erase(place);
        ended_.wait(lock, [&] { return work.helping == 0; });
    }

  private:
    explicit Helpers(bool yielding) {
        const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
        try {
            for (; started_ + 1 < cores; ++started_)
                std::thread([this, yielding] {
                    standAlone(yielding);
                    serve();
                }).detach();
        } catch (...) {
            // No more threads to be had: those that run, and those that ask, do all chunks.
        }
    }

    SharedWork* nextWanted() const {
        for (SharedWork* work : open_)
            if (work->wanted > 0) return work;
        return nullptr;
    }

    void serve() {
        std::unique_lock<std::mutex> lock(mutex_);
        while (true) {
            SharedWork* work = nullptr;
            wake_.wait(lock, [&] { return (work = nextWanted()) != nullptr; });
            --work->wanted;
            ++work->helping;
            lock.unlock();
            work->helpFromOutside();
            lock.lock();
            if (--work->helping == 0) ended_.notify_all();
        }
    }

    std::mutex mutex_;
    std::condition_variable wake_, ended_;
    std::list<SharedWork*> open_;
    unsigned started_ = 0;
};

/// Leaves its core to what is more urgent. Should that need what this thread alone can go on with, which
/// nothing does, it would wait for a moment only.
void waitWhileOthersWork() {
    constexpr std::chrono::microseconds look_again(300);
    constexpr double most_ms = 200;
    const Stopwatch watch;
    with_own_work -= own_work;
    while (isToGiveWay() && !(alone && alone->isAwaited()) && watch.milliseconds() < most_ms)
        std::this_thread::sleep_for(look_again);
    with_own_work += own_work;
}

}  // namespace

OnThisThreadAlone::OnThisThreadAlone(const std::atomic<bool>* over) : over_(over), outer_(alone) {
    alone = this;
}

OnThisThreadAlone::~OnThisThreadAlone() {
    alone = outer_;
}

HasOwnWork::HasOwnWork() : counts_(own_work == 0 && !yieldsToOtherThreads()) {
    if (!counts_) return;
    own_work = 1;
    ++with_own_work;
}

HasOwnWork::~HasOwnWork() {
    if (!counts_) return;
    own_work = 0;
    --with_own_work;
}

void forEachChunk(int count, const std::function<void(int)>& work) {
    if (isToGiveWay()) waitWhileOthersWork();
    const bool here = count < 2 || (alone && !alone->isOver());
    Helpers* const helpers = here ? nullptr : &Helpers::ofThisThread();
    // A helper more than there are cores would be given its chunk late, and all would wait for it.
    const int others = isUrgentHere() ? 0 : with_own_work - own_work;
    const int free = helpers ? helpers->count() - others : 0;
    if (free <= 0) {
        for (int chunk = 0; chunk < count; ++chunk) work(chunk);
        return;
    }
    SharedWork shared(count, work);
    helpers->run(shared, std::min(free, count - 1));
    shared.throwTrouble();
}

}  // namespace sherd
