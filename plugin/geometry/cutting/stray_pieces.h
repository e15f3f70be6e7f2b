#pragma once

#include <limits>
#include <vector>

#include "core/clustering/fragment_labels.h"
#include "core/sampling/discretisation.h"
#include "geometry/cutting/piece_shells.h"

namespace sherd {

/// Which pieces stay for themselves; two at least do.
struct PieceLimits {
    int most = std::numeric_limits<int>::max();
    double smallest_m3 = 0;
};

/// Merges stray pieces, the smallest first, each into the neighbour with which it shares most crack area; the
/// crack faces between the two vanish. A piece is a stray if it has less than a twentieth of a particle's
/// volume, or if it holds no particle of its label and is not the largest piece of it: there the smoothed
/// labels reached across a gap. So are pieces of less than `limits.smallest_m3`, and if more than
/// `limits.most` are left, the smallest of them.
void mergeStrayPieces(const LabelBoundary& boundary, const std::vector<Vec3>& points,
                      const Discretisation& solid, const FragmentLabels& labels, const PieceLimits& limits,
                      std::vector<PieceShell>& shells);

/// Makes each shell a part of its target (#shells; itself, if it stays), and drops crack faces with the same
/// shell on both sides.
void mergeShells(const std::vector<int>& target_of, const LabelBoundary& boundary,
                 std::vector<PieceShell>& shells);

}  // namespace sherd
