#pragma once

#include "core/numerics/pi.h"
#include "core/numerics/wide_vectors.h"

namespace sherd {

/// The arc tangent of x >= 0, to the last digit or two. Unlike the library's it has no branches, so that the
/// compiler can make several at once. Reduction and rational function are those of the Cephes library
/// (S. L. Moshier, 1989): atan(x) = pi / 2 - atan(1 / x) = pi / 4 + atan((x - 1) / (x + 1)).
SHERD_INLINED double arcTangent(double x) {
    constexpr double steep = 2.41421356237309504880, middling = 0.66;
    const bool is_steep = x > steep, is_flat = x <= middling;
    const double above = is_steep ? -1 : is_flat ? x : x - 1;
    const double below = is_steep ? x : is_flat ? 1 : x + 1;
    const double base = is_steep ? pi / 2 : is_flat ? 0 : pi / 4;
    const double t = above / below, z = t * t;
    const double p =
        (((-8.750608600031904122785e-1 * z - 1.615753718733365076637e1) * z - 7.500855792314704667340e1) * z -
         1.228866684490136173410e2) *
            z -
        6.485021904942025371773e1;
    const double q =
        ((((z + 2.485846490142306297962e1) * z + 1.650270098316988542046e2) * z + 4.328810604912902668951e2) *
             z +
         4.853903996359136964868e2) *
            z +
        1.945506571482613964425e2;
    return base + (t + t * (z * p / q));
}

}  // namespace sherd
