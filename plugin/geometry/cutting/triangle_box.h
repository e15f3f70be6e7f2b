#pragma once

#include <sherd/types.h>

#include <limits>
#include <vector>

#include "geometry/cutting/edge_table.h"

namespace sherd {

/// The bounding box of triangles, m; empty at first.
struct TriangleBox {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;

    void extend(const TriangleBox& other) {
        low = low.cwiseMin(other.low);
        high = high.cwiseMax(other.high);
    }
    bool meets(const TriangleBox& other) const {
        return low.x() <= other.high.x() && high.x() >= other.low.x() && low.y() <= other.high.y() &&
               high.y() >= other.low.y() && low.z() <= other.high.z() && high.z() >= other.low.z();
    }
};

inline TriangleBox boxOf(const Triangle& t, const std::vector<Vec3>& points) {
    const Vec3 &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

}  // namespace sherd
