#pragma once

#include <vector>

#include "geometry/cutting/cut_faces.h"
#include "geometry/cutting/fragment_surfaces.h"

namespace sherd {

/// Puts the closed surface of every connected piece together; cavities go with the shell around them. A piece
/// that holds no particle of its label, or next to nothing of one, is given to the neighbour with which it
/// shares most crack area. The error says what is not closed.
Result<std::vector<FragmentSurface>> assemblePieces(const TriangleMesh& body, const CutFaces& faces,
                                                    const Discretisation& solid,
                                                    const FragmentLabels& labels);

/// The volume of the pieces together over that of the body.
double volumeRatio(const TriangleMesh& body, const std::vector<FragmentSurface>& pieces);

}  // namespace sherd
