#pragma once

#include <sherd/material.h>
#include <sherd/settings.h>
#include <sherd/surface_region.h>
#include <sherd/triangle_mesh.h>

#include <vector>

#include "fracture/kept_model.h"

namespace sherd {

/// A solid with all that answers a blow without a factor.
struct BakedSolid {
    TriangleMesh surface;
    Material material;
    Settings settings;
    std::vector<SurfaceRegion> supports;
    Moments moments;
    double bounding_radius = 0, wall_thickness = 0, spacing = 0, scatter_length = 0;  ///< m
    KeptModel model;
};

}  // namespace sherd
