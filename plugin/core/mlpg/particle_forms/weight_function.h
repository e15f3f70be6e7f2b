#pragma once

namespace sherd {

/// Quartic spline weight (paper, Eq. 7) as a function of q = distance / support radius: 1 at 0, 0 from 1 on.
inline double splineWeight(double q) {
    if (q >= 1) return 0;
    const double rest = 1 - q;
    return rest * rest * rest * (1 + 3 * q);
}

/// (dw/dq) / q, finite at q = 0: the gradient of w(|x - x_i| / r) is this times (x - x_i) / r^2.
inline double splineWeightSlope(double q) {
    return q >= 1 ? 0 : -12 * (1 - q) * (1 - q);
}

}  // namespace sherd
