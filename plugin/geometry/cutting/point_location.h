#pragma once

#include <sherd/types.h>

#include <vector>

#include "geometry/cutting/edge_table.h"

namespace sherd {

/// The first triangle on the straight way from a point to a target.
struct FirstHit {
    int triangle = -1;        ///< -1: none
    bool above = false;       ///< the point lies on the side that the triangle's normal points to
    bool degenerate = false;  ///< the way passes through an edge or a vertex: choose another target
};

FirstHit firstHit(const Vec3& from, const Vec3& to, const std::vector<Vec3>& points,
                  const std::vector<Triangle>& triangles);

/// Whether a point that is not on it lies inside a closed surface that is oriented outward. For one oriented
/// inward: whether it lies outside.
bool isInside(const Vec3& x, const std::vector<Vec3>& points, const std::vector<Triangle>& surface);

}  // namespace sherd
