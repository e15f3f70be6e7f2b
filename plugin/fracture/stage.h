#pragma once

#include <sherd/result.h>

#include <string>
#include <utility>

#include "core/numerics/stopwatch.h"

namespace sherd {

/// Thrown from the stages of a blow, caught by failedIfThrown: the stage could not be done, and why.
struct StageFailed {
    std::string message;
};

/// The value of a stage, or StageFailed with the reason.
template <class T>
T valueOrFail(Result<T> result) {
    if (!result) throw StageFailed{result.error()};
    return std::move(result).value();
}

/// Runs a stage, and adds the time that it took.
template <class Stage>
auto timed(double& milliseconds, const Stage& stage) {
    const Stopwatch watch;
    auto result = stage();
    milliseconds += watch.milliseconds();
    return result;
}

}  // namespace sherd
