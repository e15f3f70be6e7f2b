#pragma once

#include <cstddef>

namespace sherd {

// Of many points, coordinate by coordinate: several at once in wide registers.

/// How far points reach along a direction.
void findReach(const float* x, const float* y, const float* z, std::size_t count, const float* way,
               float* reach);

/// The highest and the lowest of some numbers.
void findExtremes(const float* numbers, long count, float* highest, float* lowest);

/// The place of the first number that is `wanted`; one is.
int firstPlace(const float* numbers, long count, float wanted);

/// Gives each of some points to a face where it is further outside that than outside all before.
void giveWhereFurther(const float* x, const float* y, const float* z, std::size_t count, const float* normal,
                      float height, int own, float* furthest, int* face);

}  // namespace sherd
