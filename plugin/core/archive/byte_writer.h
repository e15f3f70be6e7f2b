#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace sherd {

/// Appends values to bytes: the one direction of an archive (see archive.h).
class ByteWriter {
  public:
    static constexpr bool reads = false;

    void raw(const void* from, std::size_t size) {
        const auto* bytes = static_cast<const std::byte*>(from);
        bytes_.insert(bytes_.end(), bytes, bytes + size);
    }
    /// Writes how many items follow, and returns that.
    std::size_t count(std::size_t items, std::size_t) {
        is_too_long_ = is_too_long_ || items > std::numeric_limits<std::uint32_t>::max();
        require(!is_too_long_);
        const auto stored = static_cast<std::uint32_t>(items);
        raw(&stored, sizeof stored);
        return items;
    }
    /// What is written must hold what a reader will require of it.
    void require(bool holds) { good_ = good_ && holds; }

    bool good() const { return good_; }
    /// Whether a list has more items than can be counted.
    bool isTooLong() const { return is_too_long_; }
    const std::vector<std::byte>& bytes() const { return bytes_; }

  private:
    std::vector<std::byte> bytes_;
    bool good_ = true, is_too_long_ = false;
};

}  // namespace sherd
