#pragma once

#include <vector>

#include "core/clustering/fragment_labels.h"
#include "core/sampling/discretisation.h"
#include "geometry/cutting/cut_faces.h"
#include "geometry/cutting/fragment_surfaces.h"
#include "geometry/cutting/stray_pieces.h"

namespace sherd {

/// The closed surface of every connected piece, cavities included, after stray pieces were merged into
/// neighbours (see stray_pieces.h). The error says what is not closed.
Result<std::vector<FragmentSurface>> assemblePieces(const TriangleMesh& body, const CutFaces& faces,
                                                    const Discretisation& solid, const FragmentLabels& labels,
                                                    const PieceLimits& limits);

/// The volume of all pieces over that of the body.
double volumeRatio(const TriangleMesh& body, const std::vector<FragmentSurface>& pieces);

}  // namespace sherd
