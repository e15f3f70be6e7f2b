#pragma once

#include <vector>

#include "core/sampling/discretisation.h"

namespace sherd {

/// Finds the connected pieces of sets of particles.
class ConnectedPieces {
  public:
    explicit ConnectedPieces(const Discretisation& solid)
        : solid_(solid), is_waiting_(solid.particles.size(), 0) {}

    /// The particles of each piece, ascending; the largest piece first. `members` are not empty. Particles
    /// are connected where they share a face. Specks of up to five count to the largest piece: a plane leaves
    /// steps of particles, which touch at corners. (What is really apart becomes a piece of its own in the
    /// cut.)
    std::vector<std::vector<int>> of(const std::vector<int>& members);

  private:
    std::vector<int> takePiece(int first);

    const Discretisation& solid_;
    std::vector<char> is_waiting_;  // #particles; all 0 between calls
};

}  // namespace sherd
