#include "fracture/label_particles.h"

#include "core/clustering/bisection.h"
#include "core/clustering/clusters.h"
#include "core/clustering/merge_labels.h"
#include "fracture/cluster_count.h"
#include "fracture/debris.h"

namespace sherd {

FragmentLabels labelParticles(const StrikeContext& struck, const Damage& damage, double strain_energy_j,
                              const BlowAxis& axis) {
    const FractureSettings& fracture = struck.fracture;
    const int clusters = clusterCount(struck, damage, strain_energy_j);
    const double wall = struck.solid.wallThickness();
    FragmentLabels labels =
        fracture.crack_pattern == CrackPattern::stress
            ? bisectParticles(struck.sampling, damage, clusters, fracture.largest_fragment_count, wall,
                              struck.seed, fracture.guide, axis)
            : clusterParticles(struck.sampling, damage, clusters, wall, struck.seed, fracture.guide, axis);
    const double smallest_m3 =
        fracture.debris == Debris::merged ? smallestFragment(struck.solid, fracture) : 0;
    mergeSmallest(struck.sampling, smallest_m3, fracture.largest_fragment_count, labels);
    return labels;
}

}  // namespace sherd
