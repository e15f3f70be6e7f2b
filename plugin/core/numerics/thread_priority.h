#pragma once

#if defined(__linux__)
#include <pthread.h>
#include <sched.h>
#endif

namespace sherd {

/// Lets the calling thread, and those that it starts from then on, run only where no other thread wants a
/// core. Elsewhere than on Linux it does nothing.
inline void yieldToOtherThreads() {
#if defined(__linux__)
    const sched_param none{};
    pthread_setschedparam(pthread_self(), SCHED_IDLE, &none);  // if it is refused, the thread runs as before
#endif
}

}  // namespace sherd
