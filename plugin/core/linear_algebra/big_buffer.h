#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>

namespace sherd {

/// Zero bytes, to be freed by std::free. Throws std::bad_alloc.
void* zeroedLargePages(std::size_t bytes);

/// Numbers, zero at first, on large pages where the system has them: filling a factor on small ones spends a
/// fifth of its time on page faults.
template <class Number>
class BigBuffer {
  public:
    BigBuffer() = default;
    /// Throws std::bad_alloc.
    explicit BigBuffer(std::size_t count) : size_(count) {
        if (count > 0) numbers_.reset(static_cast<Number*>(zeroedLargePages(count * sizeof(Number))));
    }

    Number* data() { return numbers_.get(); }
    const Number* data() const { return numbers_.get(); }
    std::size_t size() const { return size_; }

  private:
    struct Free {
        void operator()(Number* numbers) const { std::free(numbers); }
    };
    std::unique_ptr<Number, Free> numbers_;
    std::size_t size_ = 0;
};

}  // namespace sherd
