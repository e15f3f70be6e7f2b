#pragma once

namespace sherd {

/// What decides into how many clusters the damaged part is split.
struct ClusterBudget {
    double energy_j = 0;  ///< that goes into crack faces
    double fracture_energy_j_m2 = 1;
    double wall_thickness_m = 0;
};

/// Number of clusters whose crack faces the energy pays for: pieces of edge d and thickness t = min(d, wall)
/// have a crack area of about 2 V / d (walls) or 3 V / d (compact), so d follows from the energy, and the
/// number from d.
int affordableClusters(const ClusterBudget& budget, double damaged_volume_m3);

}  // namespace sherd
