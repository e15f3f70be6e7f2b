#pragma once

#if defined(__linux__)
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <unistd.h>
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

/// Takes from the calling thread what it has of the thread that started it: priority, the cores that it may
/// run on (then those of the program's first thread), and signals, of which it gets none. Elsewhere than on
/// Linux it does nothing.
inline void standAlone(bool yielding) {
#if defined(__linux__)
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
    cpu_set_t cores;
    if (sched_getaffinity(getpid(), sizeof cores, &cores) == 0)
        pthread_setaffinity_np(pthread_self(), sizeof cores, &cores);
    const sched_param none{};
    pthread_setschedparam(pthread_self(), yielding ? SCHED_IDLE : SCHED_OTHER, &none);
#else
    (void)yielding;
#endif
}

/// Whether the calling thread runs only where no other thread wants a core.
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
