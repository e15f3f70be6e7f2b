#pragma once

#include <vector>

#include "core/clustering/fragment_labels.h"
#include "core/damage/damage.h"
#include "core/sampling/discretisation.h"

namespace sherd {

/// Connected components of the particles with equal `state`, numbered by their first particle.
struct Parts {
    std::vector<int> of_particle;
    std::vector<int> sizes;
};
Parts connectedParts(const Discretisation& solid, const std::vector<char>& state);

/// The part of a body that is split into clusters: the damaged particles and those behind them through the
/// wall, with their overstress and stress, and without specks of either state. `axes`: see wall_axes.h.
Damage damagedRegion(const Discretisation& solid, const std::vector<Vec3>& axes, const Damage& damage,
                     double wall_thickness_m);

/// How many undamaged parts there were, at most, while the load of a blow rose to its peak: cracks have
/// parted these before what lies between grew over them, so a harder blow leaves no fewer. Looked for where
/// more than half of the body is damaged; 0 elsewhere.
int partedOnTheWay(const Discretisation& solid, const std::vector<Vec3>& axes, const Damage& damage,
                   double wall_thickness_m);

/// Gives each connected undamaged part a label of its own; returns the damaged particles, whose labels are
/// -1.
std::vector<int> labelWholeParts(const Discretisation& solid, const std::vector<char>& damaged,
                                 FragmentLabels& labels);

}  // namespace sherd
