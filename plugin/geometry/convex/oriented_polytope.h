#pragma once

#include <sherd/types.h>

namespace sherd {

/// How far some points reach along the axes, x, y, z, and along the diagonals between two of them, x + y,
/// x - y, y + z, y - z, z + x, z - x, m: a discrete oriented polytope of 18 faces, which is cheap to grow and
/// stands for the hull of the points (Klosowski et al. 1998).
struct OrientedPolytope {
    using Reach = Eigen::Array<double, 9, 1>;
    Reach low = Reach::Constant(1e30), high = -low;

    /// How far one point reaches.
    static Reach reachOf(const Vec3& x) {
        Reach along;
        along << x[0], x[1], x[2], x[0] + x[1], x[0] - x[1], x[1] + x[2], x[1] - x[2], x[2] + x[0],
            x[2] - x[0];
        return along;
    }
    void add(const Reach& point) {
        low = low.min(point);
        high = high.max(point);
    }
    void add(const OrientedPolytope& more) {
        low = low.min(more.low);
        high = high.max(more.high);
    }
    bool empty() const { return !(low[0] <= high[0]); }
    /// About that of the hull, m^3: of the smallest prism along an axis over an octagon.
    double volume() const;
    double diagonal() const { return (high - low).head<3>().matrix().norm(); }  ///< of the box, m
};

}  // namespace sherd
