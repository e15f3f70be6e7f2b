#include "core/linear_algebra/big_buffer.h"

#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace sherd {

namespace {

#ifdef __linux__
// Below, the heap has places that are warm. Larger places in it would outlive the buffer, one set a thread:
// in a room of cups that was a tenth of the memory.
constexpr std::size_t worth_own_pages = 1 << 20;  // bytes

bool hasOwnPages(std::size_t bytes) {
    return bytes >= worth_own_pages;
}

void* ownPages(std::size_t bytes) {
    void* memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    (void)madvise(memory, bytes, MADV_HUGEPAGE);  // a wish only; without large pages all works as well
    return memory;
}
#endif

}  // namespace

void* zeroedLargePages(std::size_t bytes) {
#ifdef __linux__
    if (hasOwnPages(bytes)) return ownPages(bytes);
#endif
    void* memory = std::calloc(bytes, 1);
    if (!memory) throw std::bad_alloc();
    return memory;
}

void freeLargePages(void* memory, std::size_t bytes) {
#ifdef __linux__
    if (hasOwnPages(bytes)) {
        munmap(memory, bytes);
        return;
    }
#endif
    (void)bytes;
    std::free(memory);
}

}  // namespace sherd
