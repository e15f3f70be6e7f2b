#pragma once

#include "core/clustering/fragment_labels.h"
#include "core/sampling/discretisation.h"

namespace sherd {

/// Merges fragments, the smallest first, each into the neighbour that it shares most area with, until none is
/// smaller than `smallest_m3` and at most `largest_count` are left. Fragments without neighbours stay as they
/// are.
void mergeSmallest(const Discretisation& solid, double smallest_m3, int largest_count,
                   FragmentLabels& labels);

}  // namespace sherd
