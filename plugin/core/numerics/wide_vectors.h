#pragma once

// SHERD_WIDE_VECTORS before a function compiles it for wider vector registers as well and takes what the
// processor has. Only the number of sums made at once changes: none is reordered and none contracted, so the
// bits do not. The choice is made before a sanitizer is ready for it.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SHERD_NO_WIDE_VECTORS
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define SHERD_NO_WIDE_VECTORS
#endif
#endif

#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(SHERD_NO_WIDE_VECTORS)
#define SHERD_WIDE_VECTORS __attribute__((target_clones("arch=x86-64-v4", "avx2", "default")))
#else
#define SHERD_WIDE_VECTORS
#endif

// SHERD_INLINED before a function that is done in each lane of another: it becomes part of that function, and
// so of what is compiled for wider registers.
#if defined(__GNUC__)
#define SHERD_INLINED [[gnu::always_inline]] inline
#else
#define SHERD_INLINED inline
#endif

// SHERD_NO_OVERLAP before a loop says that what it writes is nothing that it reads.
#if defined(__GNUC__) && !defined(__clang__)
#define SHERD_NO_OVERLAP _Pragma("GCC ivdep")
#else
#define SHERD_NO_OVERLAP
#endif

namespace sherd {

constexpr int wide_count = 8;
/// As many numbers side by side, in one register where it is wide enough.
using WideDoubles = double __attribute__((vector_size(wide_count * sizeof(double))));

}  // namespace sherd
