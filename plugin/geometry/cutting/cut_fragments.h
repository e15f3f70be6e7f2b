#pragma once

#include <sherd/result.h>
#include <sherd/triangle_mesh.h>

#include <cstdint>

#include "core/clustering/fragment_labels.h"
#include "core/sampling/discretisation.h"
#include "geometry/cutting/cuttable_solid.h"
#include "geometry/cutting/fragment_surfaces.h"
#include "geometry/cutting/stray_pieces.h"

namespace sherd {

struct CutSettings {
    std::uint64_t seed =
        1;  ///< of the small irregularity of crack faces on a lattice, and of their roughness
    /// How far crack faces are displaced at random, as a fraction of the particle spacing.
    double roughness = 0;
    int lattices = 6;         ///< tried before the fallback
    PieceLimits pieces = {};  ///< what is beyond them becomes part of its neighbours
};

/// Cuts a closed surface along the faces between fragments. Cracks run along the planes of the labels' crack
/// tree (see plane_cuts.h). Where there is none, where its parts touch elsewhere, and with roughness they run
/// on a lattice, where the smoothed densities of two fragments are equal, not along cells. Triangles that no
/// crack crosses are kept as they are. Both sides of a crack have the same triangles, vertex for vertex.
///
/// If none of the lattices can be cut cleanly, pieces are made on a lattice on which the outside is one more
/// fragment, and `notes` says so. They too are closed and free of self-intersection, but their outer faces
/// follow the body's only to within a lattice spacing. So they are scaled about the body's centroid until
/// their volumes, and with them their masses, add up to the body's. Their `parents` are triangles near by.
///
/// An error if the input is bad, or if a quarter of the body has walls too thin for that lattice.
/// `cuttable` was made of `solid`.
Result<FragmentSurfaces> cutFragments(const CuttableSolid& cuttable, const Discretisation& solid,
                                      const FragmentLabels& labels, const CutSettings& settings);

/// The same for a solid that is cut once.
Result<FragmentSurfaces> cutFragments(const TriangleMesh& surface, const Discretisation& solid,
                                      const FragmentLabels& labels, const CutSettings& settings);

}  // namespace sherd
