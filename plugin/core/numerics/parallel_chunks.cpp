#include "core/numerics/parallel_chunks.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace sherd {

namespace {

thread_local const OnThisThreadAlone* alone = nullptr;  // the innermost there is

}  // namespace

OnThisThreadAlone::OnThisThreadAlone(const std::atomic<bool>* over) : over_(over), outer_(alone) {
    alone = this;
}

OnThisThreadAlone::~OnThisThreadAlone() {
    alone = outer_;
}

void forEachChunk(int count, const std::function<void(int)>& work) {
    if (alone && !alone->isOver()) {
        for (int chunk = 0; chunk < count; ++chunk) work(chunk);
        return;
    }
    std::atomic<int> next{0};
    std::exception_ptr trouble;
    std::mutex trouble_mutex;
    const auto run = [&] {
        try {
            for (int chunk; (chunk = next++) < count;) work(chunk);
        } catch (...) {
            const std::lock_guard<std::mutex> lock(trouble_mutex);
            if (!trouble) trouble = std::current_exception();
            next = count;
        }
    };

    const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    std::vector<std::thread> helpers;
    try {
        for (int i = 1; i < std::min(cores, count); ++i) helpers.emplace_back(run);
    } catch (const std::system_error&) {
        // No more threads to be had: those that run, and this one, do all chunks.
    }
    run();
    for (std::thread& helper : helpers) helper.join();
    if (trouble) std::rethrow_exception(trouble);
}

}  // namespace sherd
