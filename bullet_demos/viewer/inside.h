#pragma once

#include <sherd/triangle_mesh.h>

#include <vector>

namespace demo {

/// Whether points are inside a closed surface: a line upward leaves it an odd number of times.
class InsideTest {
  public:
    explicit InsideTest(const sherd::TriangleMesh& surface);
    bool contains(const sherd::Vec3& point) const;

  private:
    std::size_t columnOf(double x, double y) const;

    const sherd::TriangleMesh& surface_;
    Eigen::AlignedBox3d box_;
    int width_ = 1;                          ///< columns along x and along y
    std::vector<std::vector<int>> columns_;  ///< the triangles over each
};

}  // namespace demo
