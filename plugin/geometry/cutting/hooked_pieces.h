#pragma once

#include <vector>

#include "geometry/cutting/piece_shells.h"

namespace sherd {

/// Merges pieces that are hooked into their neighbours, the smallest first, each into the neighbour with
/// which it shares most crack area. A piece is hooked if, whichever way it is moved, more than a twentieth of
/// its crack area is in the way: faces along the direction by more than 10 degrees. Rough faces count as the
/// smooth ones that they were.
void mergeHookedPieces(const LabelBoundary& boundary, const CutFaces& faces, std::vector<PieceShell>& shells);

}  // namespace sherd
