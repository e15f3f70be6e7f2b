#include "geometry/convex/oriented_polytope.h"

#include <algorithm>
#include <limits>

namespace sherd {

namespace {

/// Area of the octagon across an axis, m^2: a rectangle without its corners.
double octagon(const OrientedPolytope& of, int axis) {
    const auto &low = of.low, &high = of.high;
    const int p = (axis + 1) % 3, q = (axis + 2) % 3, sum = 3 + 2 * p, difference = sum + 1;
    const auto corner = [](double side) { return side > 0 ? side * side / 2 : 0; };
    return (high[p] - low[p]) * (high[q] - low[q]) - corner(high[p] + high[q] - high[sum]) -
           corner(low[sum] - low[p] - low[q]) - corner(high[p] - low[q] - high[difference]) -
           corner(high[q] - low[p] + low[difference]);
}

}  // namespace

double OrientedPolytope::volume() const {
    double least = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
        least = std::min(least, (high[axis] - low[axis]) * octagon(*this, axis));
    return least;
}

}  // namespace sherd
