#pragma once

#include <sherd/triangle_mesh.h>

#include <string>
#include <vector>

#include "geometry/surface_topology.h"

namespace sherd {

/// A connected part of a surface.
struct Shell {
    std::vector<int> triangles;
    Eigen::AlignedBox3d box;
    double volume_m3 = 0;  ///< negative where the triangles face inward
    double area_m2 = 0;
    int first_vertex = -1;

    /// Whether it encloses next to nothing for its area.
    bool isFlat() const;
};

/// The connected parts of a surface, in the order of their first triangles.
std::vector<Shell> shellsOf(const TriangleMesh& mesh, const std::vector<SharedEdge>& edges);

/// How many solids a closed surface bounds that do not touch; cavities are none.
int solidCount(const TriangleMesh& mesh);

/// "The part of the surface at (0, 0, 1) (triangle 7)".
std::string describeShell(const TriangleMesh& mesh, const Shell& shell);

/// " (3 such parts)"; nothing for a single one.
std::string suchParts(std::size_t count);

}  // namespace sherd
