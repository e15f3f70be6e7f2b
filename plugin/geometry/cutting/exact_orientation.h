#pragma once

#include <sherd/types.h>

#include <algorithm>
#include <cmath>

namespace sherd {

/// Exact sign (-1, 0, 1) of (b - a) x (c - a) . (d - a): 1 when d is on the side that the normal of a, b, c
/// points to.
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The same volume (six times that of the tetrahedron) in floating point, m^3.
inline double signedVolume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return (b - a).cross(c - a).dot(d - a);
}

/// The plane through three points, for exact signs of many: those that floating point is sure of cost no
/// more than a dot product.
class OrientedPlane {
  public:
    OrientedPlane(const Vec3& a, const Vec3& b, const Vec3& c)
        : a_(a),
          b_(b),
          c_(c),
          normal_((b - a).cross(c - a)),
          largest_((b - a).cwiseAbs().cwiseMax((c - a).cwiseAbs())) {}

    /// orientation(a, b, c, d)
    int side(const Vec3& d) const {
        // Shewchuk's bound of the rounding error, 7.8e-16 times the sum of the six products' absolute values
        // (Adaptive precision floating-point arithmetic and fast robust geometric predicates, 1997).
        constexpr double error = 5.2e-15, smallest = 1e-90;  // products of smaller ones might underflow
        const Vec3 e = d - a_;
        const double volume = normal_.x() * e.x() + normal_.y() * e.y() + normal_.z() * e.z();
        const double x = std::max(largest_.x(), std::abs(e.x())), y = std::max(largest_.y(), std::abs(e.y())),
                     z = std::max(largest_.z(), std::abs(e.z())), bound = error * x * y * z;
        if (std::abs(volume) > bound && std::min({x, y, z}) > smallest) return volume > 0 ? 1 : -1;
        return orientation(a_, b_, c_, d);
    }

  private:
    const Vec3 &a_, &b_, &c_;
    Vec3 normal_, largest_;
};

}  // namespace sherd
