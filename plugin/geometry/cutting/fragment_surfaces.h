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
        parents;  ///< #T, the triangle of the cut surface that each is a part of; -1 for new crack faces
    std::vector<int> across;  ///< #T, the piece on the other side of a new crack face; -1 elsewhere
    int label = -1;           ///< several connected pieces may come from one label
};

struct FragmentSurfaces {
    std::vector<FragmentSurface> pieces;  ///< each connected, closed, oriented outward
    std::vector<std::string> notes;       ///< fallbacks taken, with their consequence
};

struct CutSettings {
    std::uint64_t seed = 1;  ///< of the small irregularity of the crack faces, and of their roughness
    double roughness =
        0;             ///< how far crack faces are displaced at random, as a fraction of the particle spacing
    int lattices = 6;  ///< tried before the fallback
};

/// Cuts a closed surface along the faces between fragments. Cracks run where two fragments are equally near
/// in a smoothed sense, not along cells; triangles that no crack crosses are kept as they are; both sides of
/// a crack share its triangles vertex for vertex.
/// The fallback, when no lattice can be cut cleanly (`notes` says so): pieces made on a lattice, where the
/// outside is one more fragment. They are as closed and free of self-intersection as all others, but their
/// outside follows the body's to within a lattice spacing only, so they are scaled about the body's centroid
/// until their volumes, and with them their masses, add up to the body's. Their `parents` are triangles near
/// by. An error only if the input is bad, or if walls of a quarter of the body are too thin for that lattice.
Result<FragmentSurfaces> cutFragments(const TriangleMesh& surface, const Discretisation& solid,
                                      const FragmentLabels& labels, const CutSettings& settings);

}  // namespace sherd
