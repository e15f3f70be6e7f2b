#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>

namespace sherd {

/// Numbers, zero at first, on large pages where the system has them: filling a factor on small ones spends a
/// fifth of its time on page faults.
class BigBuffer {
  public:
    BigBuffer() = default;
    /// Throws std::bad_alloc.
    explicit BigBuffer(std::size_t count);

    double* data() { return numbers_.get(); }
    const double* data() const { return numbers_.get(); }
    std::size_t size() const { return size_; }

  private:
    struct Free {
        void operator()(double* numbers) const { std::free(numbers); }
    };
    std::unique_ptr<double, Free> numbers_;
    std::size_t size_ = 0;
};

}  // namespace sherd
