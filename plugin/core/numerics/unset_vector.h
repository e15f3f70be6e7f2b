#pragma once

#include <memory>
#include <utility>
#include <vector>

namespace sherd {

/// Leaves new items as they are where nothing is given to make them of.
template <class T>
struct UnsetAllocator : std::allocator<T> {
    UnsetAllocator() = default;
    template <class U>
    explicit UnsetAllocator(const UnsetAllocator<U>&) {}
    template <class U>
    struct rebind {
        using other = UnsetAllocator<U>;
    };
    template <class U, class... Arguments>
    void construct(U* at, Arguments&&... arguments) {
        if constexpr (sizeof...(Arguments) == 0)
            ::new (static_cast<void*>(at)) U;
        else
            ::new (static_cast<void*>(at)) U(std::forward<Arguments>(arguments)...);
    }
};

/// A list of numbers whose `resize` does not set them: for megabytes that are filled at once.
template <class T>
using UnsetVector = std::vector<T, UnsetAllocator<T>>;

}  // namespace sherd
