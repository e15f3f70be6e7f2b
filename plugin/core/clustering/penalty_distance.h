#pragma once

#include <sherd/settings.h>
#include <sherd/types.h>

#include "core/loads/blow.h"

namespace sherd {

/// Eq. 18 of the paper: |AB - (1 - lambda) (AB . v) v|, v the unit vector of the guide field in the middle
/// between the two points, m. Points along the field are near to each other, so fragments grow along it (the
/// paper's sentence says across; its figures say along).
///
/// In a radial field v is that at the seed, away from the axis of the blow, for seen from a seed the lines of
/// a star are straight; what lies beyond the axis counts in full; and lambda counts along that axis as well:
/// the cracks of a struck pane go straight through it.
double penaltyDistance(const Vec3& seed, const Vec3& x, const GuideField& guide, const BlowAxis& blow);

}  // namespace sherd
