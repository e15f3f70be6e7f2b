#pragma once

#include <sherd/triangle_mesh.h>

#include <Eigen/Geometry>
#include <vector>

#include "geometry/cutting/edge_table.h"

namespace sherd {

/// A surface with what every cut needs of it and none changes.
class CuttableSurface {
  public:
    /// The surface has to outlive this.
    explicit CuttableSurface(const TriangleMesh& mesh);

    const TriangleMesh& mesh() const { return mesh_; }
    const EdgeTable& edges() const { return edges_; }
    /// Whether each edge has two triangles, which run along it in opposite directions.
    bool isClosed() const { return is_closed_; }

    /// Triangles that follow each other in the mesh are mostly near each other: a block of them is looked at
    /// once.
    int blockCount() const { return static_cast<int>(block_boxes_.size()); }
    /// The first triangle of a block; for `blockCount()` the number of triangles.
    int blockBegin(int block) const;
    const std::vector<Eigen::AlignedBox3d>& blockBoxes() const { return block_boxes_; }

  private:
    const TriangleMesh& mesh_;
    EdgeTable edges_;
    bool is_closed_;
    std::vector<Eigen::AlignedBox3d> block_boxes_;
};

}  // namespace sherd
