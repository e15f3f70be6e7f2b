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

    /// Triangles that are near each other: a block of them is looked at once.
    int blockCount() const { return static_cast<int>(block_boxes_.size()); }
    const std::vector<Eigen::AlignedBox3d>& blockBoxes() const { return block_boxes_; }
    /// Calls visit(triangle) for those of a block.
    template <class Visit>
    void forEachIn(int block, const Visit& visit) const {
        for (int i = blockBegin(block); i < blockBegin(block + 1); ++i) visit(order_[i]);
    }

  private:
    int blockBegin(int block) const;

    const TriangleMesh& mesh_;
    EdgeTable edges_;
    bool is_closed_;
    std::vector<int> order_;  // #triangles, block after block
    std::vector<Eigen::AlignedBox3d> block_boxes_;
};

}  // namespace sherd
