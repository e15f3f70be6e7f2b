#pragma once

#include <sherd/triangle_mesh.h>

#include "core/sampling/discretisation.h"

namespace sherd {

/// Volume, centroid and second moment of the solid that a closed surface bounds, of unit density (divergence
/// theorem).
Moments solidMoments(const TriangleMesh& mesh);

}  // namespace sherd
