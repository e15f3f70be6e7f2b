#include "fracture/cluster_count.h"

#include <algorithm>

#include "core/clustering/affordable_clusters.h"
#include "fracture/debris.h"

namespace sherd {

int clusterCount(const StrikeContext& struck, const Damage& damage, double strain_energy_j) {
    const FractureSettings& fracture = struck.fracture;
    if (fracture.fragment_count > 0) return fracture.fragment_count;
    double damaged_volume = 0;
    for (std::size_t i = 0; i < damage.damaged.size(); ++i)
        if (damage.damaged[i]) damaged_volume += struck.sampling.particles[i].volume;
    const ClusterBudget budget{fracture.energy_into_cracks * strain_energy_j,
                               struck.solid.material().fracture_energy_j_m2, struck.solid.wallThickness()};
    const int room =
        static_cast<int>(std::clamp(damaged_volume / smallestFragment(struck.solid, fracture), 1.0, 1e6));
    return std::min({affordableClusters(budget, damaged_volume), room, fracture.largest_fragment_count});
}

}  // namespace sherd
