#pragma once

#include <cstddef>
#include <memory>

namespace sherd {

/// Zero bytes, to be freed by `freeLargePages`. Throws std::bad_alloc.
void* zeroedLargePages(std::size_t bytes);
void freeLargePages(void* memory, std::size_t bytes);

/// Numbers, zero at first, on large pages where the system has them: filling a factor on small ones spends a
/// fifth of its time on page faults. Many numbers go back to the system with the buffer: a heap would keep
/// their place, and a thread that once solved a large body would hold it for good.
template <class Number>
class BigBuffer {
  public:
    BigBuffer() = default;
    /// Throws std::bad_alloc.
    explicit BigBuffer(std::size_t count) {
        const std::size_t bytes = count * sizeof(Number);
        if (count > 0) numbers_ = {static_cast<Number*>(zeroedLargePages(bytes)), Free{bytes}};
    }

    Number* data() { return numbers_.get(); }
    const Number* data() const { return numbers_.get(); }
    std::size_t size() const { return numbers_.get_deleter().bytes / sizeof(Number); }

  private:
    struct Free {
        std::size_t bytes = 0;
        void operator()(Number* numbers) const { freeLargePages(numbers, bytes); }
    };
    std::unique_ptr<Number, Free> numbers_;
};

}  // namespace sherd
