#pragma once

#include <sherd/surface_region.h>

#include <vector>

#include "scenes/json_fields.h"

namespace demo {

/// The key `supports` of a body: regions of its surface that the world holds, each an object with one of
/// sphere, box and cylinder, in the shape's own coordinates.
void readSupports(Fields& body, std::vector<sherd::SurfaceRegion>& supports);

}  // namespace demo
