#include "cli/bake_command.h"

#include <sherd/breakable_asset.h>
#include <sherd/fields.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <vector>

#include "cli/mesh_options.h"

namespace sherd::cli {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The least of a few: what else the machine does only adds to it.
Result<double> secondsToLoad(const std::string& path) {
    constexpr int times = 5;
    std::vector<double> seconds;
    for (int i = 0; i < times; ++i) {
        const auto start = Clock::now();
        const auto loaded = BreakableAsset::load(path);
        seconds.push_back(secondsSince(start));
        if (!loaded) return Error{loaded.error()};
    }
    return *std::min_element(seconds.begin(), seconds.end());
}

}  // namespace

Result<Material> materialOf(const BakeArguments& arguments) {
    const std::filesystem::path path = arguments.material;
    return path.extension() == ".json" ? Material::fromJsonFile(arguments.material)
                                       : Material::named(arguments.material);
}

Result<Settings> settingsOf(const BakeArguments& arguments) {
    Result<Settings> settings = arguments.settings.empty()
                                    ? Settings::forQuality(*valueNamed<Quality>(arguments.quality))
                                    : Settings::fromJsonFile(arguments.settings);
    if (!settings) return settings;
    if (const Status changed = settings.value().set(arguments.changes); !changed)
        return Error{changed.error()};
    return settings;
}

Status runBake(const BakeArguments& arguments, std::ostream& report) {
    const auto material = materialOf(arguments);
    if (!material) return Error{material.error()};
    const auto settings = settingsOf(arguments);
    if (!settings) return Error{settings.error()};

    const auto start = Clock::now();
    const auto asset =
        BreakableAsset::fromObj(arguments.mesh, material.value(), settings.value(), arguments.repair);
    if (!asset) return Error{asset.error()};
    if (const Status saved = asset.value().save(arguments.out); !saved) return saved;
    const double seconds = secondsSince(start);
    for (const std::string& repair : asset.value().repairs().sentences())
        std::cerr << "note: " << withOptions(repair) << "\n";
    for (const std::string& warning : asset.value().warnings())
        std::cerr << "warning: " << withOptions(warning) << "\n";

    const auto loading = secondsToLoad(arguments.out);
    if (!loading) return Error{loading.error()};
    constexpr double megabyte = 1e6, millisecond = 1e-3;
    report << std::fixed << std::setprecision(1) << arguments.out << ": " << asset.value().particleCount()
           << " particles, " << asset.value().unknownCount() << " unknowns, "
           << static_cast<double>(std::filesystem::file_size(arguments.out)) / megabyte << " MB; made in "
           << seconds << " s, loads in " << loading.value() / millisecond << " ms\n";
    return success();
}

}  // namespace sherd::cli
