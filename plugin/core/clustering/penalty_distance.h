#pragma once

#include <sherd/settings.h>
#include <sherd/types.h>

#include "core/loads/blow.h"

namespace sherd {

/// Distance of a point from a seed by Eq. 18 of the paper: |AB - (1 - lambda) (AB . v) v|, with lambda the
/// guide field's `cost_along` and v its unit vector in the middle between the two points, m. Points along the
/// field are near to each other, so fragments grow along it (the paper's sentence says across; its figures
/// say along).
///
/// In a radial field v is taken at the seed, away from the axis of the blow, since a ray through the seed is
/// straight. The part of the way beyond the axis counts in full. Distances along the axis are multiplied by
/// lambda too: the cracks of a struck pane go straight through it.
double penaltyDistance(const Vec3& seed, const Vec3& x, const GuideField& guide, const BlowAxis& blow);

/// The same at one place: multiplied with a short offset at x it makes the part along the field lambda times
/// as long, and in a radial field that along the axis of the blow too.
Mat3 guideStretch(const Vec3& x, const GuideField& guide, const BlowAxis& blow);

}  // namespace sherd
