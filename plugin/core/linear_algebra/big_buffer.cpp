#include "core/linear_algebra/big_buffer.h"

#include <new>

#ifdef __linux__
#include <sys/mman.h>

#include <cstdint>
#endif

namespace sherd {

BigBuffer::BigBuffer(std::size_t count) : size_(count) {
    if (count == 0) return;
    numbers_.reset(static_cast<double*>(std::calloc(count, sizeof(double))));
    if (!numbers_) throw std::bad_alloc();
#ifdef __linux__
    constexpr std::uintptr_t page = 4096;
    const auto address = reinterpret_cast<std::uintptr_t>(numbers_.get());
    const std::uintptr_t begin = (address + page - 1) / page * page,
                         end = (address + count * sizeof(double)) / page * page;
    // A wish only; without large pages all works as well.
    if (end > begin) (void)madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#endif
}

}  // namespace sherd
