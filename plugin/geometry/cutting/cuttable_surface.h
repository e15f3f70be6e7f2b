#pragma once

#include <sherd/triangle_mesh.h>

#include "geometry/cutting/edge_table.h"
#include "geometry/cutting/triangle_box.h"

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

    /// Triangles that follow each other in the mesh are mostly near each other: runs of this many are looked
    /// at together first.
    static constexpr int run_length = 16;
    const std::vector<TriangleBox>& boxesOfRuns() const { return boxes_of_runs_; }

  private:
    const TriangleMesh& mesh_;
    EdgeTable edges_;
    bool is_closed_;
    std::vector<TriangleBox> boxes_of_runs_;
};

}  // namespace sherd
