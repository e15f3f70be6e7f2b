#pragma once

#include <sherd/result.h>

#include <vector>

#include "geometry/cutting/label_boundary.h"

namespace sherd {

/// Boundary triangles that together bound one piece, cavities included.
struct PieceShell {
    std::vector<int> triangles;
    int label = -1;
    std::vector<int> merged_labels;  ///< of the pieces that became part of it
    double volume = 0;               ///< m^3
    Eigen::AlignedBox3d box;         ///< of its outer surface, m; empty until `findBoxes`
};

/// The connected pieces of all labels. Each cavity is part of the smallest shell of its label around it.
/// Volumes are summed about `origin`. The error says what is not closed.
Result<std::vector<PieceShell>> pieceShells(const LabelBoundary& boundary, const CutFaces& faces,
                                            const Vec3& origin);

/// Finds the bounding boxes of all shells.
void findBoxes(const LabelBoundary& boundary, const std::vector<Vec3>& points,
               std::vector<PieceShell>& shells);

/// Whether a point that is not on it lies inside a shell's surface; `findBoxes` comes first.
bool contains(const PieceShell& shell, const Vec3& x, const LabelBoundary& boundary,
              const std::vector<Vec3>& points);

/// The shell of every boundary triangle; -1: of none.
std::vector<int> pieceOfTriangle(const std::vector<PieceShell>& shells, const LabelBoundary& boundary);

void removeEmptyShells(std::vector<PieceShell>& shells);

}  // namespace sherd
