#pragma once

#include <vector>

#include "core/clustering/fragment_labels.h"
#include "core/sampling/discretisation.h"
#include "geometry/cutting/piece_shells.h"

namespace sherd {

/// Merges stray pieces, the smallest first, each into the neighbour with which it shares most crack area; the
/// crack faces between the two vanish. A piece is a stray if it has less than a twentieth of a particle's
/// volume, or if it holds no particle of its label and is not the largest piece of it: there the smoothed
/// labels reached across a gap. If more than `most_pieces` are left, so are the smallest of them.
void mergeStrayPieces(const LabelBoundary& boundary, const std::vector<Vec3>& points,
                      const Discretisation& solid, const FragmentLabels& labels, int most_pieces,
                      std::vector<PieceShell>& shells);

/// Makes each shell a part of its target (#shells; itself, if it stays), and drops crack faces with the same
/// shell on both sides.
void mergeShells(const std::vector<int>& target_of, const LabelBoundary& boundary,
                 std::vector<PieceShell>& shells);

}  // namespace sherd
