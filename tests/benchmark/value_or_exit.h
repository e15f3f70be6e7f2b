#pragma once

#include <sherd/result.h>

#include <cstdio>
#include <cstdlib>
#include <utility>

namespace sherd::benchmarks {

/// The value, or the end of the program with the sentence that says why there is none.
template <class T>
T valueOrExit(Result<T> result) {
    if (result) return std::move(result).value();
    std::fprintf(stderr, "%s\n", result.error().c_str());
    std::exit(1);
}

inline void succeedOrExit(const Status& status) {
    if (status) return;
    std::fprintf(stderr, "%s\n", status.error().c_str());
    std::exit(1);
}

}  // namespace sherd::benchmarks
