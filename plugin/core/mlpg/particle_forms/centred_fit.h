#pragma once

#include <sherd/types.h>

namespace sherd {

/// Weighted least-squares fit of a linear function, written about the weighted mean of its points. Directions
/// in which the points do not spread (coplanar, collinear, single) get no slope instead of a wild one;
/// constants are always reproduced, and linear functions as far as the points determine them.
class CentredFit {
  public:
    void add(const Vec3& point, double weight);

    /// Call after the last `add`. Slopes along directions whose standard deviation is below `smallest_spread`
    /// (m) are dropped. False when there is no weight at all.
    bool finish(double smallest_spread);

    int rank() const { return rank_; }
    const Vec3& mean() const { return mean_; }

    /// Factor of the datum at `point` in the fit's mean value.
    double valueFactor(double weight) const { return weight / weight_; }

    /// Factors of the datum at `point` in the fit's gradient.
    Vec3 slopeFactor(const Vec3& point, double weight) const {
        return valueFactor(weight) * (inverse_covariance_ * (point - mean_));
    }

    /// Factor of the datum at `point` in the fit's value at `x`.
    double factorAt(const Vec3& x, const Vec3& point, double weight) const {
        return valueFactor(weight) + slopeFactor(point, weight).dot(x - mean_);
    }

  private:
    double weight_ = 0;
    int rank_ = 0;
    Vec3 origin_ =
        Vec3::Zero();  // first point: sums are kept relative to it, against cancellation far from (0, 0, 0)
    Vec3 mean_ = Vec3::Zero();
    Mat3 inverse_covariance_ = Mat3::Zero();
};

}  // namespace sherd
