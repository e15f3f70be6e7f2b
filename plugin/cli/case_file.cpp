#include "cli/case_file.h"

#include <filesystem>

#include "io/material_entry.h"

namespace sherd::cli {

namespace {

SurfaceRegion region(const JsonEntry& entry) {
    entry.allowOnly({"sphere", "box", "cylinder"});
    if (entry.has("sphere") + entry.has("box") + entry.has("cylinder") != 1)
        entry.fail("must be one of sphere, box and cylinder");
    if (entry.has("sphere")) {
        const JsonEntry sphere = entry["sphere"];
        sphere.allowOnly({"centre", "radius"});
        return SphereRegion{sphere["centre"].vector(), sphere["radius"].number()};
    }
    if (entry.has("box")) {
        const JsonEntry box = entry["box"];
        box.allowOnly({"lo", "hi"});
        return BoxRegion{box["lo"].vector(), box["hi"].vector()};
    }
    const JsonEntry cylinder = entry["cylinder"];
    cylinder.allowOnly({"point", "axis", "radius"});
    return CylinderRegion{cylinder["point"].vector(), cylinder["axis"].vector(), cylinder["radius"].number()};
}

SurfaceLoad load(const JsonEntry& entry) {
    entry.allowOnly({"region", "force_n", "pressure_pa"});
    if (entry.has("force_n") == entry.has("pressure_pa"))
        entry.fail("must have either force_n (the total, three numbers) or pressure_pa");
    SurfaceLoad load;
    load.region = region(entry["region"]);
    if (entry.has("force_n")) load.force_n = entry["force_n"].vector();
    if (entry.has("pressure_pa")) load.pressure_pa = entry["pressure_pa"].number();
    return load;
}

SurfaceRegion support(const JsonEntry& entry) {
    entry.allowOnly({"region"});
    return region(entry["region"]);
}

StressCase stressCase(const JsonEntry& entry, const std::filesystem::path& folder) {
    StressCase read;
    // These four are for people.
    read.unknown_keys = entry.keysBeside({"name", "description", "smallest_thickness_m", "reference",  //
                                          "mesh", "material", "loads", "supports", "spin_rad_s"});
    if (entry.has("name")) read.name = entry["name"].text();
    read.mesh = (folder / entry["mesh"].text()).string();
    read.material = materialOf(entry["material"], folder.string(), Missing::but_needed);
    for (const JsonEntry& item : entry["loads"].list()) read.loads.push_back(load(item));
    if (entry.has("supports"))
        for (const JsonEntry& item : entry["supports"].list()) read.supports.push_back(support(item));
    if (entry.has("spin_rad_s")) read.spin_rad_s = entry["spin_rad_s"].vector();
    if (read.loads.empty() && read.spin_rad_s.isZero(0))
        entry["loads"].fail("is empty and there is no spin_rad_s, so nothing loads the body");
    return read;
}

}  // namespace

Result<StressCase> readCase(const std::string& path) {
    return readJson<StressCase>(path, [&](const JsonEntry& entry) {
        return stressCase(entry, std::filesystem::path(path).parent_path());
    });
}

}  // namespace sherd::cli
