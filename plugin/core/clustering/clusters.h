#pragma once

#include <sherd/settings.h>

#include <cstdint>

#include "core/clustering/fragment_labels.h"
#include "core/damage/damage.h"
#include "core/loads/blow.h"
#include "core/sampling/discretisation.h"

namespace sherd {

/// Labels (paper, sections 6.1 and 6.2): each connected undamaged part is one, and so is each cluster of
/// damaged particles. A particle is in the cluster of its nearest seed; seeds are spread by farthest point,
/// denser where the stress is higher. Specks (undamaged or damaged parts of up to five particles) take the
/// state of what surrounds them. Damage on one side of a wall reaches through it. A count of 1 means that
/// nothing came off.
///
/// Distances are path lengths along the neighbour table, or with a guide field those of Eq. 18; then too
/// clusters grow along the neighbour table, so that each is connected.
FragmentLabels clusterParticles(const Discretisation& solid, const Damage& damage, int clusters,
                                double wall_thickness_m, std::uint64_t seed, const GuideField& guide = {},
                                const BlowAxis& blow = {});

}  // namespace sherd
