#include "bullet/shapes/pooled.h"

#include <memory_resource>

namespace sherd {

namespace {

constexpr std::size_t alignment = 16;  // of Bullet's vectors

std::pmr::memory_resource& pool() {
    static std::pmr::memory_resource& pool =
        *new std::pmr::synchronized_pool_resource;  // outlives all worlds
    return pool;
}

}  // namespace

void* Pooled::operator new(std::size_t size) {
    return pool().allocate(size, alignment);
}

void Pooled::operator delete(void* place, std::size_t size) {
    pool().deallocate(place, size, alignment);
}

}  // namespace sherd
