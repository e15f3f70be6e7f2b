#pragma once

#include <cstddef>

namespace sherd {

/// What there is one of for each body: all of a kind lie side by side. Bullet goes through its bodies many
/// times in a step, and where other memory lies between them a world asleep takes 3 % longer.
struct Pooled {
    static void* operator new(std::size_t size);
    static void operator delete(void* place, std::size_t size);
};

}  // namespace sherd
