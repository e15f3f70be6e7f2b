#pragma once

#include "core/clustering/fragment_labels.h"
#include "fracture/strike_context.h"
#include "geometry/cutting/fragment_surfaces.h"

namespace sherd {

/// Cuts the surface between particles of different labels. The particles of one label may come apart in the
/// cut, at a neck of few particles. Where that makes more pieces than the settings allow, the smallest labels
/// are merged (`labels` is changed), and the surface is cut again; more pieces are left only where two labels
/// alone make them.
Result<FragmentSurfaces> cutWithinLimit(const StrikeContext& struck, FragmentLabels& labels);

}  // namespace sherd
