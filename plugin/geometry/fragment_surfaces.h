#pragma once

#include <sherd/result.h>
#include <sherd/triangle_mesh.h>

#include <cstdint>
#include <string>
#include <vector>

#include "core/clustering/fragment_labels.h"
#include "core/sampling/discretisation.h"

namespace sherd {

/// The closed surface of one fragment, in the frame of the body it came from.
struct FragmentSurface {
    TriangleMesh mesh;
    std::vector<int>
        parents;     ///< #T, the triangle of the cut surface that each is a part of; -1 for new crack faces
    int label = -1;  ///< several connected pieces may come from one label
};

struct FragmentSurfaces {
    std::vector<FragmentSurface> pieces;  ///< each connected, closed, oriented outward
    std::vector<std::string> notes;       ///< fallbacks taken, with their consequence
};

/// Cuts a closed surface along the faces between fragments. Cracks run where two fragments are equally near
/// in a smoothed sense, not along cells; triangles that no crack crosses are kept as they are; both sides of
/// a crack share its triangles vertex for vertex. The seed fixes the small irregularity of the crack faces.
Result<FragmentSurfaces> cutFragments(const TriangleMesh& surface, const Discretisation& solid,
                                      const FragmentLabels& labels, std::uint64_t seed);

}  // namespace sherd
