#pragma once

#include <sherd/stress_field.h>

#include "core/mlpg/splines/spline_problem.h"
#include "core/mlpg/splines/zoom.h"
#include "core/stress/near_field.h"

namespace sherd {

/// Where a solid's particles, then its surface points, lie in its grid.
std::vector<GridPoint> locateSamples(const Discretisation& solid);

/// Reads the stress of a displacement at the particles, at the surface points (both located in `samples`) and
/// at `points`, each on the finest grid that knows it, into `field`.
void readStress(const SplineProblem& problem, const std::vector<GridPoint>& samples, const SplineField& whole,
                const std::vector<Zoom>& zooms, const std::vector<Vec3>& points, StressField& field);

/// Adds the near field of contacts to a stress that was read without it, also at its places, and gives
/// surfaces the traction that acts there, as far as it is known.
void addNearField(const Discretisation& solid, const ContactField& contact, const Elasticity& elasticity,
                  StressField& field);

}  // namespace sherd
