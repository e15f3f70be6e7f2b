#pragma once

#include <sherd/material.h>
#include <sherd/repair.h>
#include <sherd/result.h>
#include <sherd/settings.h>

#include <iosfwd>
#include <string>

namespace sherd::cli {

/// What `sherd bake` is asked for.
struct BakeArguments {
    std::string mesh;      ///< path of the OBJ
    std::string material;  ///< name, or path of a JSON file
    std::string settings;  ///< path of a JSON file; empty: those of the quality
    std::string quality = "game";
    std::vector<std::string> changes;  ///< "sampling.spacing_m=0.002"
    Repair repair;
    std::string out;
};

/// Material and settings that are asked for; the error names the file or the field.
Result<Material> materialOf(const BakeArguments& arguments);
Result<Settings> settingsOf(const BakeArguments& arguments);

/// `sherd bake`: mesh in, baked asset out. Says on `report` what was made, notes and warnings on standard
/// error.
Status runBake(const BakeArguments& arguments, std::ostream& report);

}  // namespace sherd::cli
