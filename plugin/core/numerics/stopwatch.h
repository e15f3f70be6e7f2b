#pragma once

#include <chrono>

namespace sherd {

/// Milliseconds since it was made.
class Stopwatch {
  public:
    double milliseconds() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Adds the time from its making to its end to a sum of milliseconds.
class AddedTime {
  public:
    explicit AddedTime(double& milliseconds) : milliseconds_(milliseconds) {}
    ~AddedTime() { milliseconds_ += watch_.milliseconds(); }
    AddedTime(const AddedTime&) = delete;
    AddedTime& operator=(const AddedTime&) = delete;

  private:
    double& milliseconds_;
    Stopwatch watch_;
};

/// Runs a stage, and adds the time that it took, also if it throws.
template <class Stage>
decltype(auto) timed(double& milliseconds, const Stage& stage) {
    const AddedTime time(milliseconds);
    return stage();
}

}  // namespace sherd
