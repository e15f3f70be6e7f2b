#include "core/numerics/urgent_work.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>
#include <vector>

#include "core/numerics/job.h"
#include "core/numerics/made_once.h"
#include "core/numerics/parallel_chunks.h"
#include "core/numerics/worker_threads.h"

namespace sherd {
namespace {

constexpr int many =
    1000000;  // chunks: tens of milliseconds; a thread that stopped before each would take days

void doChunks(std::atomic<int>& done) {
    forEachChunk(1, [&](int) { ++done; });
}

void waitFor(std::atomic<int>& done, int count) {
    while (done < count) std::this_thread::sleep_for(std::chrono::microseconds(100));
}

std::shared_ptr<Job> jobOfMany(std::atomic<int>& done) {
    return Job::make([&done] {
        for (int i = 0; i < many; ++i) doChunks(done);
    });
}

TEST(UrgentWork, StopsThreadsThatGiveWay) {
    std::atomic<int> done{0};
    std::atomic<bool> ending{false};
    const auto job = Job::make([&] {
        while (!ending) doChunks(done);
    });
    const Executor patient = patientWorkerThreads(GivesWay::to_urgent, 1);
    job->submit(patient);
    waitFor(done, 1);
    {
        const UrgentWork urgent;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));  // it comes to its next chunk
        const int before = done;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        EXPECT_LT(done - before, 5);
    }
    waitFor(done, done + many);
    ending = true;
    job->finish();
}

TEST(UrgentWork, WaitsForNoThreadThatItStopped) {
    std::atomic<int> done{0};
    const auto job = jobOfMany(done);
    const Executor patient = patientWorkerThreads(GivesWay::to_urgent, 1);
    job->submit(patient);
    waitFor(done, 1);
    const UrgentWork urgent;
    job->finish();
    EXPECT_EQ(done, many);
}

TEST(UrgentWork, WaitsForNothingThatAThreadWhichStoppedIsMaking) {
    std::atomic<int> done{0};
    MadeOnce<int> made;
    const auto make = [&] {
        for (int i = 0; i < many; ++i) doChunks(done);
        return 7;
    };
    const auto job = Job::make([&] { (void)made.get(make); });
    const Executor patient = patientWorkerThreads(GivesWay::to_urgent, 1);
    job->submit(patient);
    waitFor(done, 1);
    {
        const UrgentWork urgent;
        EXPECT_EQ(made.get(make), 7);
    }
    job->finish();
    EXPECT_EQ(done, many) << "made twice";
}

TEST(UrgentWork, StopsNothingThatIsToHurry) {
    std::atomic<int> done{0};
    const auto job = jobOfMany(done);
    const Executor patient = patientWorkerThreads(GivesWay::to_urgent, 1);
    job->submit(patient);
    waitFor(done, 1);
    const UrgentWork urgent;
    job->hurry();
    waitFor(done, many);
    job->finish();
}

/// The step keeps a core of its own, whatever is made ahead.
TEST(PatientWorkerThreads, StopWhereOthersAreBusyOnAllCoresButOne) {
    const int others = static_cast<int>(std::thread::hardware_concurrency()) - 1;
    if (others < 1) GTEST_SKIP() << "one core";
    std::atomic<int> done{0}, begun{0};
    std::atomic<bool> ending{false}, ending_ahead{false};
    const Executor workers = patientWorkerThreads(GivesWay::to_urgent, others);
    const Executor ahead = patientWorkerThreads(GivesWay::to_all, 1);
    const auto last = Job::make([&] {
        while (!ending_ahead) doChunks(done);
    });
    last->submit(ahead);
    waitFor(done, 1);
    std::vector<std::shared_ptr<Job>> jobs;
    for (int i = 0; i < others; ++i) {
        jobs.push_back(Job::make([&] {
            ++begun;
            while (!ending) std::this_thread::sleep_for(std::chrono::microseconds(100));
        }));
        jobs.back()->submit(workers);
    }
    waitFor(begun, others);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));  // it comes to its next chunk
    const int before = done;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_LT(done - before, 5);
    ending = true;
    for (const auto& job : jobs) job->finish();
    waitFor(done, done + many);
    ending_ahead = true;
    last->finish();
}

TEST(UrgentWork, LeavesOtherThreadsAlone) {
    std::atomic<int> done{0};
    const auto job = jobOfMany(done);
    const Executor ordinary = workerThreads(1);
    const UrgentWork urgent;
    job->submit(ordinary);
    waitFor(done, many);
    job->finish();
}

}  // namespace
}  // namespace sherd
