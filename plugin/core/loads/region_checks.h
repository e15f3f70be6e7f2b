#pragma once

#include <sherd/result.h>
#include <sherd/surface_region.h>

namespace sherd {

/// The error says which number of a region is not finite or describes no shape.
Status checkRegion(const SurfaceRegion& region);

}  // namespace sherd
