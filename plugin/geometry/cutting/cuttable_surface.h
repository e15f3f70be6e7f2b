#pragma once

#include <sherd/triangle_mesh.h>

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

  private:
    const TriangleMesh& mesh_;
    EdgeTable edges_;
    bool is_closed_;
};

}  // namespace sherd
