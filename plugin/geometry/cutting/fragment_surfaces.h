#pragma once

#include <sherd/triangle_mesh.h>

#include <string>
#include <vector>

namespace sherd {

/// The closed surface of one fragment, in the frame of the body it came from.
struct FragmentSurface {
    TriangleMesh mesh;
    std::vector<int>
        parents;  ///< #T, the triangle of the cut surface that each is a part of; -1 for new crack faces
    std::vector<int> across;         ///< #T, the piece on the other side of a new crack face; -1 elsewhere
    int label = -1;                  ///< several connected pieces may come from one label
    std::vector<int> merged_labels;  ///< of small pieces that became part of it
};

/// All fragments of a body.
struct FragmentSurfaces {
    std::vector<FragmentSurface> pieces;  ///< each connected, closed, oriented outward
    std::vector<std::string> notes;       ///< fallbacks taken, with their consequence
};

}  // namespace sherd
