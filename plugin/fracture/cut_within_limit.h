#pragma once

#include "core/clustering/fragment_labels.h"
#include "fracture/strike_context.h"
#include "geometry/cutting/fragment_surfaces.h"

namespace sherd {

/// Cuts the surface between fragments. One of them may come apart in the cut, at a neck of few particles;
/// where that makes more pieces than the settings allow, the smallest fragments are merged in `labels` to
/// make room, and the surface is cut again.
Result<FragmentSurfaces> cutWithinLimit(const StrikeContext& struck, FragmentLabels& labels);

}  // namespace sherd
