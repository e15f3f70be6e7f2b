#pragma once

#include <chrono>
#include <future>
#include <memory>
#include <utility>

namespace demo {

/// Work on another thread that nobody waits for any more.
class LeftOver {
  public:
    virtual ~LeftOver() = default;
    virtual bool done() const = 0;
};

/// Keeps it until it is done; at the end of the program that is waited for.
void leaveToItself(std::unique_ptr<LeftOver> work);

template <class T>
bool isReady(const std::future<T>& future) {
    return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

/// A future's destructor would wait for what std::async began, and the window would freeze.
template <class T>
void leaveToItself(std::future<T> future) {
    struct Work : LeftOver {
        explicit Work(std::future<T> its_future) : future(std::move(its_future)) {}
        bool done() const override { return isReady(future); }
        std::future<T> future;
    };
    if (future.valid()) leaveToItself(std::unique_ptr<LeftOver>(new Work(std::move(future))));
}

}  // namespace demo
