#pragma once

#include <sherd/types.h>

#include <functional>
#include <vector>

#include "core/loads/surface_tree.h"

namespace sherd {

/// What contacts that push alike enclose, seen along their push: the convex hull of their points, since
/// Bullet keeps four points of a flat contact, and a margin round it.
class Footprint {
  public:
    /// `push` is a unit vector; there is at least one point.
    Footprint(const std::vector<Vec3>& contacts, const Vec3& push, double margin_m);

    /// Coordinates in the plane at right angles to the push, m.
    Vec2 project(const Vec3& x) const { return axes_ * x; }
    const Vec3& push() const { return push_; }
    /// Distance outside of the margin, as seen along the push, m; 0 inside.
    double outside(const Vec3& x) const;
    /// Whether some point within `reach` of x may be inside; looks at no more than the hull's box first.
    bool isNear(const Vec3& x, double reach) const {
        return box_.exteriorDistance(project(x)) <= margin_ + reach && outside(x) <= reach;
    }
    double length() const { return size_.maxCoeff(); }  ///< m
    double width() const { return size_.minCoeff(); }   ///< m
    double area() const;                                ///< about, m^2

  private:
    Vec3 push_;
    double margin_;
    Eigen::Matrix<double, 2, 3> axes_;
    Vec2 size_;
    std::vector<Vec2> hull_;
    Eigen::AlignedBox2d box_;  ///< of the hull
};

/// A part of a surface seen along the push of a footprint.
struct FootprintPart {
    Vec3 centre = Vec3::Zero();  ///< m
    double area_m2 = 0;          ///< as seen along the push
};

/// How long a part may be, m, that lies within `reach` of a place in the footprint's plane.
using LengthOfParts = std::function<double(const Vec2& place, double reach)>;

/// The surface over a footprint that faces its push, in parts no longer than `longest` says; only what lies
/// no deeper than `depth` inside of its outermost part.
std::vector<FootprintPart> partsOver(const SurfaceTree& tree, const Footprint& footprint,
                                     const LengthOfParts& longest, double depth);

}  // namespace sherd
