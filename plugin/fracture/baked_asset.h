#pragma once

#include <sherd/repair.h>

#include <string>
#include <vector>

#include "core/archive/checked_file.h"
#include "fracture/baked_solid.h"

namespace sherd {

/// What a file of `sherd bake` keeps.
struct BakedAsset {
    BakedSolid solid;
    RepairReport repairs;
    std::vector<std::string> warnings;
};

/// The version is to be raised when anything changes that the file holds: a field of a struct in it, how
/// solids are sampled, the trial functions or the reduced model.
inline const FileFormat baked_format{"sherdbak", 10, "baked asset", "bake the asset again (`sherd bake`)"};

/// BreakableAsset::save and load say what the errors are.
Status saveBaked(BakedAsset& asset, const std::string& path);
Result<BakedAsset> loadBaked(const std::string& path);

}  // namespace sherd
