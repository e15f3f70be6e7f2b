#pragma once

#include <sherd/result.h>
#include <sherd/times.h>

#include <algorithm>
#include <string>
#include <utility>

#include "core/mlpg/stress_solver.h"
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

/// Adds what making a stress solver took: its factor, and all the rest of it.
inline void addMaking(const StressSolver& made, double took_ms, StageTimes& ms) {
    const double factor_ms = std::min(made.report().factor_ms, took_ms);  // it may be of another thread
    ms.factor += factor_ms;
    ms.assemble += took_ms - factor_ms;
}

}  // namespace sherd
