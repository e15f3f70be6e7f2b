#pragma once

#include <sherd/settings.h>

#include <cstdint>

#include "core/clustering/fragment_labels.h"
#include "core/damage/damage.h"
#include "core/loads/blow.h"
#include "core/sampling/discretisation.h"

namespace sherd {

/// What decides into how many clusters the damaged part goes.
struct ClusterBudget {
    double energy_j = 0;  ///< elastic energy of the blow
    double fracture_energy_j_m2 = 1;
    double wall_thickness_m = 0;
};

/// Number of clusters whose crack faces the energy pays for: pieces of edge d and thickness t = min(d, wall)
/// have a crack area of about 2 V / d (walls) or 3 V / d (compact), so d follows from the energy, and the
/// number from d.
int affordableClusters(const ClusterBudget& budget, double damaged_volume_m3);

/// Fragments (paper, sections 6.1 and 6.2): each connected undamaged part is one; damaged particles are
/// clustered to seeds spread by farthest point along the neighbour table, denser where the stress is higher.
/// Specks (an undamaged or damaged part of up to five particles) join what surrounds them. Damage on one side
/// of a wall reaches through it. Count 1 means: nothing came off.
///
/// With a guide field distances are those of Eq. 18 instead of path lengths, and clusters grow from
/// their seeds along the neighbour table, so that they keep together.
FragmentLabels fragmentLabels(const Discretisation& solid, const Damage& damage, int clusters,
                              double wall_thickness_m, std::uint64_t seed, const GuideField& guide = {},
                              const BlowAxis& blow = {});

}  // namespace sherd
