#include "fracture/cut_within_limit.h"

#include <algorithm>

#include "core/clustering/merge_labels.h"
#include "geometry/cutting/cut_fragments.h"

namespace sherd {

Result<FragmentSurfaces> cutWithinLimit(const StrikeContext& struck, FragmentLabels& labels) {
    const CutSettings cut{struck.seed, struck.fracture.crack_roughness};
    while (true) {
        Result<FragmentSurfaces> surfaces =
            cutFragments(struck.solid.cuttable(struck.sampling), struck.sampling, labels, cut);
        if (!surfaces) return surfaces;
        const int count = labels.count, pieces = static_cast<int>(surfaces.value().pieces.size()),
                  excess = pieces - struck.fracture.largest_fragment_count;
        if (excess > 0) mergeSmallest(struck.sampling, 0, std::max(2, count - excess), labels);
        if (excess <= 0 || labels.count == count) return surfaces;
    }
}

}  // namespace sherd
