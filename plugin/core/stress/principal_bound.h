#pragma once

#include <cmath>

#include "core/numerics/wide_vectors.h"

namespace sherd {

/// An upper bound of cos(t) for c = cos(3 t), 0 <= t <= 60 degrees, at most 0.03 above it. It is concave in
/// c, so it lies below its tangents, of which these are some: cos(t) + (c - cos(3 t)) sin(t) / (3 sin(3 t)).
template <class Scalar>
SHERD_INLINED Scalar thirdOfAngle(Scalar c) {
    constexpr Scalar tangents[6][2] = {{Scalar(0.88890), Scalar(0.11111)},   // t = 0 degrees, rounded up
                                       {Scalar(0.87389), Scalar(0.13164)},   // 20
                                       {Scalar(0.86604), Scalar(0.16667)},   // 30
                                       {Scalar(0.88976), Scalar(0.24741)},   // 40
                                       {Scalar(1.08508), Scalar(0.51070)},   // 50
                                       {Scalar(1.85931), Scalar(1.32915)}};  // 56
    Scalar least = tangents[0][0] + tangents[0][1] * c;
    for (int i = 1; i < 6; ++i) {
        const Scalar on_tangent = tangents[i][0] + tangents[i][1] * c;
        least = on_tangent < least ? on_tangent : least;
    }
    return least;
}

/// Bounds of the principal values of a symmetric tensor, without branches: the largest is
///     m + 2 sqrt(J_2 / 3) cos(t), cos(3 t) = (3 sqrt(3) / 2) J_3 / J_2^(3/2),
/// with the mean m and the invariants of the deviator, and the smallest that of the tensor mirrored.
/// `smallest` <= 0 <= `largest`. `rounding`: of the numbers, relative.
template <class Scalar>
SHERD_INLINED void boundPrincipal(Scalar xx, Scalar yy, Scalar zz, Scalar xy, Scalar yz, Scalar zx,
                                  Scalar rounding, Scalar& smallest, Scalar& largest) {
    const Scalar mean = (xx + yy + zz) / 3, size_of_mean = mean < 0 ? -mean : mean;
    const Scalar x = xx - mean, y = yy - mean, z = zz - mean;
    const Scalar two_j2 = x * x + y * y + z * z + 2 * (xy * xy + yz * yz + zx * zx);
    const Scalar reach = std::sqrt(two_j2 * Scalar(2.0 / 3));  // 2 sqrt(J_2 / 3)
    const Scalar per_reach = reach > 0 ? 1 / reach : 0;
    const Scalar a = x * per_reach, b = y * per_reach, c = z * per_reach;
    const Scalar d = xy * per_reach, e = yz * per_reach, f = zx * per_reach;
    const Scalar cosine = 4 * (a * (b * c - e * e) - d * (d * c - e * f) + f * (d * e - b * f));
    const Scalar slack = rounding * (reach + 2 * size_of_mean);
    const Scalar highest = mean + reach * thirdOfAngle(cosine) + slack;
    const Scalar lowest = mean - reach * thirdOfAngle(-cosine) - slack;
    largest = highest <= 0 ? 0 : highest;  // what is no number stays so, and is looked at
    smallest = lowest >= 0 ? 0 : lowest;
}

}  // namespace sherd
