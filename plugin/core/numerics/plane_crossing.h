#pragma once

#include <sherd/types.h>

namespace sherd {

/// Walks around a polygon that a plane may part in two (Sutherland and Hodgman 1974). For each of its `count`
/// corners calls corner(i, above), and behind a corner whose next one lies on the other side crossing(i,
/// next, above), where `above` is the side of corner i as isAbove(i) tells.
template <class IsAbove, class Corner, class Crossing>
void walkAcrossPlane(int count, const IsAbove& isAbove, const Corner& corner, const Crossing& crossing) {
    for (int i = 0; i < count; ++i) {
        const int next = i + 1 == count ? 0 : i + 1;
        const bool above = isAbove(i);
        corner(i, above);
        if (above != isAbove(next)) crossing(i, next, above);
    }
}

/// Where the line from a to b meets a plane that they lie at two different signed heights over.
inline Vec3 planeCrossing(const Vec3& a, double height_of_a, const Vec3& b, double height_of_b) {
    return a + height_of_a / (height_of_a - height_of_b) * (b - a);
}

}  // namespace sherd
