#include "core/numerics/job.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cfenv>
#include <chrono>
#include <future>
#include <stdexcept>
#include <thread>
#include <vector>

namespace sherd {
namespace {

TEST(Job, IsDoneOnceByWhomeverComesFirst) {
    const Executor four = workerThreads(4);
    std::atomic<int> done{0};
    std::vector<std::shared_ptr<Job>> jobs;
    for (int i = 0; i < 200; ++i) {
        jobs.push_back(Job::make([&] { ++done; }));
        jobs.back()->submit(four);
    }
    for (const auto& job : jobs) job->finish();
    EXPECT_EQ(done, 200);
}

TEST(Job, IsDoneWhereItIsNeededIfNobodyHasBegun) {
    for (const Executor& executor :
         {Executor(), Executor([](std::function<void()>) {}),
          Executor([](std::function<void()>) { throw std::runtime_error("no room"); })}) {
        std::thread::id by;
        const auto job = Job::make([&] { by = std::this_thread::get_id(); });
        job->submit(executor);
        job->finish();
        EXPECT_EQ(by, std::this_thread::get_id());
        EXPECT_TRUE(job->doneHere());
    }
}

TEST(Job, IsWaitedForWhereAnotherThreadHasBegun) {
    std::atomic<bool> begun{false}, may_end{false};
    bool done = false;
    const auto job = Job::make([&] {
        begun = true;
        while (!may_end) std::this_thread::yield();
        done = true;
    });
    const Executor one = workerThreads(1);
    job->submit(one);
    while (!begun) std::this_thread::yield();
    std::thread later([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        may_end = true;
    });
    job->finish();
    EXPECT_TRUE(done);
    EXPECT_FALSE(job->doneHere());
    later.join();
}

TEST(Job, IsLeftWhereAnotherThreadHasBegun) {
    std::atomic<bool> begun{false}, may_end{false};
    const auto job = Job::make([&] {
        begun = true;
        while (!may_end) std::this_thread::yield();
    });
    const Executor one = workerThreads(1);
    job->submit(one);
    while (!begun) std::this_thread::yield();
    job->doIfFree();  // returns at once: it would never end otherwise
    may_end = true;
    job->finish();
    EXPECT_FALSE(job->doneHere());
    const auto free = Job::make([] {});
    free->doIfFree();
    free->finish();
    EXPECT_TRUE(free->doneHere());
}

TEST(Job, RoundsAsWhereItWasMade) {
    const Executor one = workerThreads(1);
    ASSERT_EQ(std::fesetround(FE_UPWARD), 0);
    int rounding = -1;
    const auto job = Job::make([&] { rounding = std::fegetround(); });
    std::fesetround(FE_TONEAREST);
    job->submit(one);
    job->finish();
    EXPECT_EQ(rounding, FE_UPWARD);
    EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

TEST(WorkerThreads, EndWithTheirExecutor) {
    std::atomic<int> done{0};
    {
        const Executor two = workerThreads(2);
        for (int i = 0; i < 20; ++i) two([&] { ++done; });
    }
    const int at_the_end = done;
    std::this_thread::yield();
    EXPECT_EQ(done, at_the_end);
}

TEST(Job, OneThatIsAtWorkIsWaitedForAWhile) {
    std::promise<void> goes_on, has_begun;
    const auto job = Job::make([&] {
        has_begun.set_value();
        goes_on.get_future().wait();
    });
    job->waitIfBegun(1e6);  // nobody is at it
    EXPECT_FALSE(job->isDone());
    EXPECT_EQ(job->begunFor_ms(), 0);
    std::thread worker;
    job->submit([&](std::function<void()> work) { worker = std::thread(std::move(work)); });
    has_begun.get_future().wait();
    job->waitIfBegun(1);
    EXPECT_FALSE(job->isDone());
    EXPECT_GE(job->begunFor_ms(), 1);
    goes_on.set_value();
    job->waitIfBegun(1e6);
    EXPECT_TRUE(job->isDone());
    worker.join();
}

}  // namespace
}  // namespace sherd
