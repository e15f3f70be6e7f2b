#pragma once

#include <sherd/types.h>

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "geometry/cutting/edge_table.h"

namespace sherd {

/// The polygons that segments cut a triangle into, which the triangles in them connect.
struct TrianglePolygons {
    int count = 0;
    std::vector<int> of_part;                         ///< #triangles, the polygon that each is part of
    std::vector<int> at_edge;                         ///< #loop, that at the edge which begins at each point
    std::vector<std::array<int, 2>> beside_segments;  ///< #segments, those on their left and right
};

/// Splits triangles along segments by constrained Delaunay triangulation in the triangle's plane, without
/// adding points.
class TriangleSubdivision {
  public:
    TriangleSubdivision();
    ~TriangleSubdivision();

    /// `loop`: the corners and the points on the edges, counter-clockwise about `normal`; `segments`: pairs
    /// of points of the loop or inside it. Appends triangles of the same orientation, and tells which
    /// polygons they make up. False, with nothing appended, if rounding makes the segments cross or fold.
    bool split(const std::vector<Vec3>& points, const Vec3& normal, const std::vector<int>& loop,
               const std::vector<std::pair<int, int>>& segments, std::vector<Triangle>& out,
               TrianglePolygons& polygons);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace sherd
