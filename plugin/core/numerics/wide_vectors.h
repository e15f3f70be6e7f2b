#pragma once

// SHERD_WIDE_VECTORS before a function compiles it for wider vector registers as well and takes what the
// processor has. Only the number of sums made at once changes: none is reordered and none contracted, so the
// bits do not.
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(SHERD_NO_WIDE_VECTORS)
#define SHERD_WIDE_VECTORS __attribute__((target_clones("arch=x86-64-v4", "avx2", "default")))
#else
#define SHERD_WIDE_VECTORS
#endif
