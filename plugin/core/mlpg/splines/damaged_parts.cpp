#include "core/mlpg/splines/damaged_parts.h"

#include "core/sampling/nearest_owner.h"

namespace sherd {

std::vector<double> stiffnessShares(const Discretisation& solid, const std::vector<char>& damaged) {
    constexpr double damaged_share = 1e-4;  // keeps what damaged material holds together from drifting
    std::vector<double> shares;
    if (damaged.empty()) return shares;
    for (const CellPart& part : solid.parts.parts)
        shares.push_back(damaged[nearestOwner(solid, solid.parts.centroid(part))] ? damaged_share : 1);
    return shares;
}

}  // namespace sherd
