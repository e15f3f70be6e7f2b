#pragma once

#include <vector>

namespace sherd {

/// Which fragment every particle belongs to.
struct FragmentLabels {
    std::vector<int> of_particle;  ///< #particles, 0 <= label < count
    int count = 0;
};

}  // namespace sherd
