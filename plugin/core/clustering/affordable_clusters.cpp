#include "core/clustering/affordable_clusters.h"

#include <algorithm>

namespace sherd {

int affordableClusters(const ClusterBudget& budget, double damaged_volume_m3) {
    const double area = budget.energy_j / budget.fracture_energy_j_m2;
    if (!(area > 0)) return 1;
    const double wall = budget.wall_thickness_m;
    double edge = 2 * damaged_volume_m3 / area;
    double count = damaged_volume_m3 / (edge * edge * wall);
    if (edge < wall) {
        edge = 3 * damaged_volume_m3 / area;
        count = damaged_volume_m3 / (edge * edge * edge);
    }
    return static_cast<int>(std::clamp(count, 1.0, 1e6));
}

}  // namespace sherd
