#pragma once

#include <vector>

namespace sherd {

/// The face that two pieces of the solid share.
struct SharedFace {
    int pieces[2] = {-1, -1};
    double area = 0;  ///< in faces of a whole grid cell
};

/// Merges small pieces of grid cells into neighbours, the smallest first, each into the one that it shares
/// most area with. A piece is small if it fills less than `fraction` of a cell and is less deep (volume over
/// shared area) than a corner of a cell that fills `fraction`. So the pieces of a sheet or a rod that is thin
/// everywhere are not merged along it. Volumes are in whole grid cells.
///
/// Returns for each piece the one that it became part of; that one's entry is itself.
std::vector<int> mergeSmall(std::vector<double> volumes, const std::vector<SharedFace>& faces,
                            double fraction);

}  // namespace sherd
