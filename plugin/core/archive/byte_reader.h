#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace sherd {

/// Takes values from bytes: the other direction of an archive (see archive.h). Where the bytes are not those
/// of a writer, it is no longer `good`, and gives zeros and empty lists from there on.
class ByteReader {
  public:
    static constexpr bool reads = true;

    ByteReader(const std::byte* bytes, std::size_t size) : first_(bytes), at_(bytes), end_(bytes + size) {}

    void raw(void* to, std::size_t size) {
        if (size == 0) return;
        require(size <= left());
        if (good_) {
            std::memcpy(to, at_, size);
            at_ += size;
        } else {
            std::memset(to, 0, size);
        }
    }
    /// The next bytes as they lie there, if so many are left; nullptr if not. Takes none of them.
    const std::byte* next(std::size_t size) const { return good_ && size <= left() ? at_ : nullptr; }
    /// Takes bytes that were looked at.
    void skip(std::size_t size) { at_ += size; }
    /// How many items follow, each of `least_bytes` or more; 0 if so many cannot follow, so that no size in a
    /// broken file decides what is allocated.
    std::size_t count(std::size_t, std::size_t least_bytes) {
        std::uint32_t stored = 0;
        raw(&stored, sizeof stored);
        require(stored <= left() / (least_bytes > 0 ? least_bytes : 1));
        return good_ ? stored : 0;
    }
    void require(bool holds) { good_ = good_ && holds; }

    bool good() const { return good_; }
    std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
    /// Bytes taken so far.
    std::size_t position() const { return static_cast<std::size_t>(at_ - first_); }

  private:
    const std::byte *first_, *at_, *end_;
    bool good_ = true;
};

}  // namespace sherd
