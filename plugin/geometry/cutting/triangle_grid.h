#pragma once

#include <sherd/types.h>

#include <vector>

#include "geometry/cutting/edge_table.h"

namespace sherd {

/// Finds triangles near a box: their bounding boxes are sorted into the cells of a grid.
class TriangleGrid {
  public:
    TriangleGrid(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);

    /// Appends the triangles whose bounding boxes meet the box [low, high], each once, in ascending order.
    void findNear(const Vec3& low, const Vec3& high, std::vector<int>& found) const;

  private:
    template <class Visit>
    void forEachCell(const Vec3& low, const Vec3& high, Visit visit) const;

    std::vector<Vec3> low_, high_;  // boxes of the triangles
    Vec3 origin_ = Vec3::Zero(), end_ = Vec3::Zero();
    double cells_per_m_ = 1;
    Eigen::Vector3i size_ = Eigen::Vector3i::Zero();
    std::vector<int> first_, entries_;
};

}  // namespace sherd
