#pragma once

#include <sherd/material.h>
#include <sherd/result.h>
#include <sherd/surface_region.h>

#include <string>
#include <vector>

namespace sherd::cli {

/// A body under loads, as a case file describes it. SI units.
struct StressCase {
    std::string name;
    std::string mesh;  ///< path of the OBJ
    Material material;
    std::vector<SurfaceLoad> loads;
    std::vector<SurfaceRegion> supports;  ///< where u = 0; empty: the body is free
    Vec3 spin_rad_s = Vec3::Zero();
    std::vector<std::string> unknown_keys;  ///< of the outermost object: passed over, perhaps misspelt
};

/// Reads a case (JSON; tests/data/cases/README.md describes it). The error names the file and the key, and
/// says what is expected there.
Result<StressCase> readCase(const std::string& path);

}  // namespace sherd::cli
