#include "core/linear_algebra/big_buffer.h"

#include <new>

#ifdef __linux__
#include <sys/mman.h>

#include <cstdint>
#endif

namespace sherd {

void* zeroedLargePages(std::size_t bytes) {
    void* memory = std::calloc(bytes, 1);
    if (!memory) throw std::bad_alloc();
#ifdef __linux__
    constexpr std::uintptr_t page = 4096;
    const auto address = reinterpret_cast<std::uintptr_t>(memory);
    const std::uintptr_t begin = (address + page - 1) / page * page, end = (address + bytes) / page * page;
    // A wish only; without large pages all works as well.
    if (end > begin) (void)madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#endif
    return memory;
}

}  // namespace sherd
