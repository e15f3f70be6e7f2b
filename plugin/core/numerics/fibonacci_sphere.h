#pragma once

#include <sherd/types.h>

#include <cmath>

#include "core/numerics/pi.h"

namespace sherd {

/// The unit vector `number` of `count` that are spread evenly over all directions, from +z to -z.
inline Vec3 fibonacciDirection(int number, int count) {
    const double z = 1 - (2 * number + 1.0) / count, r = std::sqrt(1 - z * z),
                 angle = number * pi * (3 - std::sqrt(5.0));
    return {r * std::cos(angle), r * std::sin(angle), z};
}

}  // namespace sherd
