#include "fracture/label_particles.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "core/clustering/bisection.h"
#include "core/clustering/clusters.h"
#include "core/clustering/merge_labels.h"
#include "core/loads/contact_loads.h"
#include "fracture/cluster_count.h"
#include "fracture/crack_energy.h"
#include "fracture/crack_reach.h"
#include "fracture/debris.h"

namespace sherd {

namespace {

constexpr double stops_cracks = 10;  // strength, in that of the weakest damaged particle

/// Marks particles (#, or empty: none) of a painted strength at which cracks from weaker material stop.
std::vector<char> whereCracksStop(const StrikeContext& struck, const Damage& damage) {
    if (!struck.solid.strength().isPainted()) return {};
    std::vector<double> strengths;
    double weakest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < damage.damaged.size(); ++i) {
        strengths.push_back(struck.solid.strength().at().at(struck.sampling.particles[i].position));
        if (damage.damaged[i]) weakest = std::min(weakest, strengths[i]);
    }
    std::vector<char> holds(damage.damaged.size());
    for (std::size_t i = 0; i < holds.size(); ++i)
        holds[i] = !damage.damaged[i] && strengths[i] > stops_cracks * weakest;
    return holds;
}

}  // namespace

FragmentLabels labelParticles(const StrikeContext& struck, const Damage& damage, const BlowForces& forces) {
    const FractureSettings& fracture = struck.fracture;
    const BlowAxis axis = axisOf(forces.strike);
    const int clusters = clusterCount(struck, damage, forces.strain_energy_j);
    const double wall = struck.solid.wallThickness();
    // Boxes stand for whole cells: cracks through cells would leave pieces without any.
    const bool through_cells =
        fracture.crack_pattern == CrackPattern::stress && fracture.collision_shape != CollisionShape::boxes;
    FragmentLabels labels =
        through_cells
            ? bisectParticles(struck.sampling, struck.solid.wallAxes(struck.sampling), damage, clusters,
                              fracture.largest_fragment_count, wall, struck.seed,
                              whereCracksStop(struck, damage), holeOf(struck, damage, forces), fracture.guide,
                              axis, affordableCrackArea(struck.solid, fracture, forces.strain_energy_j))
            : clusterParticles(struck.sampling, damage, clusters, wall, struck.seed, fracture.guide, axis);
    const double smallest_m3 =
        fracture.debris == Debris::merged ? smallestFragment(struck.solid, fracture) : 0;
    mergeSmallest(struck.sampling, smallest_m3, fracture.largest_fragment_count, labels);
    return labels;
}

}  // namespace sherd
