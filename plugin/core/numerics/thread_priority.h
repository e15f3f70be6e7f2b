#pragma once

#if defined(__linux__)
#include <pthread.h>
#include <sched.h>
#endif

namespace sherd {

/// Lets the calling thread run only where no other thread wants a core, and what it shares out to others
/// (`forEachChunk`) too. Elsewhere than on Linux it does nothing.
inline void yieldToOtherThreads() {
#if defined(__linux__)
    const sched_param none{};
    pthread_setschedparam(pthread_self(), SCHED_IDLE, &none);  // if it is refused, the thread runs as before
#endif
}

/// Whether the calling thread does so.
inline bool yieldsToOtherThreads() {
#if defined(__linux__)
    int policy = SCHED_OTHER;
    sched_param ignored{};
    return pthread_getschedparam(pthread_self(), &policy, &ignored) == 0 && policy == SCHED_IDLE;
#else
    return false;
#endif
}

}  // namespace sherd
