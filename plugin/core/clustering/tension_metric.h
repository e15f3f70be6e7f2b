#pragma once

#include <sherd/settings.h>

#include <vector>

#include "core/damage/damage.h"
#include "core/loads/blow.h"
#include "core/sampling/discretisation.h"

namespace sherd {

/// How the blow stretches distances at a particle. Cracks shorten what is long in this measure.
struct TensionMetric {
    /// A short way d has the length sqrt(d . tensor d): far along the largest tension, short across it.
    Mat3 tensor = Mat3::Identity();
    double pieces = 1;  ///< that the particle is to become, a small part of one
};

/// #particles, so that the body is `pieces` pieces in all. With principal stresses s_1 >= s_2 >= s_3 within
/// the wall and o = min(overstress, 3), or 0 below 0.5, the tensor has the principal values (o max(s_i, 0) /
/// s_1)^4 + 0.15^2. So lengths go with the square of the tension, as the energy does that a crack across it
/// releases; right under a contact the stress is that of the load's patch and counts as 3. `axes`: see
/// wall_axes.h. A guide field v multiplies the metric as in Eq. 18: what lies along v is lambda times as
/// long.
///
/// Pieces are to be as large as the distance from the blow (with the loads' own radius, and a particle
/// spacing) over the overstress. About a contact that makes a power law of their sizes: there is no other
/// length.
std::vector<TensionMetric> tensionMetrics(const Discretisation& solid, const std::vector<Vec3>& axes,
                                          const Damage& damage, int pieces, double wall_thickness_m,
                                          const GuideField& guide, const BlowAxis& blow);

}  // namespace sherd
