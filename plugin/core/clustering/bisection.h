#pragma once

#include <sherd/settings.h>

#include <cstdint>
#include <limits>

#include "core/clustering/crack_tree.h"
#include "core/clustering/fragment_labels.h"
#include "core/damage/damage.h"
#include "core/loads/blow.h"
#include "core/sampling/discretisation.h"

namespace sherd {

/// Labels for CrackPattern::stress: divisive clustering in the metric that the blow's stress makes (see
/// tension_metric.h). The body is cut in two by a plane (see best_cut.h), and so is the part that would still
/// become most pieces, until there are as many as `clusters` and the connected undamaged parts together, and
/// at most `most_pieces`. A plane cuts one part only, so later cracks end at earlier ones. Cracks start where
/// the body is damaged, but run through undamaged material, except where it `holds` (#particles, or
/// empty: nowhere): what is connected there stays whole. What a cut leaves unconnected is a part of its
/// own, or if it is too little joins the neighbour that it touches most. Where there is a `hole`, a convex
/// part of the body with planes whose normals point out of it, cracks run in it and around it: the rest stays
/// whole. Cracks have no more area than is `affordable_m2`, but for those of a hole. A count of 1 means that
/// nothing came off: nothing but specks (see damaged_region.h) is damaged. `axes`: see wall_axes.h.
FragmentLabels bisectParticles(const Discretisation& solid, const std::vector<Vec3>& axes,
                               const Damage& damage, int clusters, int most_pieces, double wall_thickness_m,
                               std::uint64_t seed, const std::vector<char>& holds = {},
                               const std::vector<CrackPlane>& hole = {}, const GuideField& guide = {},
                               const BlowAxis& blow = {},
                               double affordable_m2 = std::numeric_limits<double>::infinity());

}  // namespace sherd
