// What a baked asset takes: bake_benchmark FILE.obj [PRESET [RUNS]]. Prints seconds to make it, to save it
// and to prepare the same in memory, megabytes of the file, and milliseconds to load it, the file being
// cached.

#include <sherd/breakable_asset.h>
#include <sherd/fields.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "core/numerics/stopwatch.h"

using namespace sherd;

namespace {

int failed(const std::string& sentence) {
    std::fprintf(stderr, "%s\n", sentence.c_str());
    return 1;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) return failed("usage: bake_benchmark FILE.obj [PRESET [RUNS]]");
    const auto quality = valueNamed<Quality>(argc > 2 ? argv[2] : "game");
    if (!quality) return failed("the presets are " + listOf(namesInFiles<Quality>()));
    const int runs = argc > 3 ? std::max(1, std::atoi(argv[3])) : 30;
    const std::string file = (std::filesystem::temp_directory_path() / "sherd_bake_benchmark.sherd").string();

    Stopwatch watch;
    const auto asset = BreakableAsset::fromObj(argv[1], Material::ceramic(), Settings::forQuality(*quality));
    if (!asset) return failed(asset.error());
    const double made_ms = watch.milliseconds();
    watch = {};
    if (const Status prepared = asset.value().prepare(); !prepared) return failed(prepared.error());
    const double prepared_ms = watch.milliseconds();
    watch = {};
    if (const Status saved = asset.value().save(file); !saved) return failed(saved.error());
    const double saved_ms = watch.milliseconds();

    std::vector<double> load_ms;
    for (int run = 0; run < runs; ++run) {
        watch = {};
        const auto loaded = BreakableAsset::load(file);
        load_ms.push_back(watch.milliseconds());
        if (!loaded) return failed(loaded.error());
    }
    std::sort(load_ms.begin(), load_ms.end());
    std::printf(
        "%d particles; made in %.2f s, prepared in %.2f s, saved in %.2f s; %.2f MB; loaded in %.1f ms "
        "(median of %d; %.1f the least)\n",
        asset.value().particleCount(), made_ms / 1e3, prepared_ms / 1e3, saved_ms / 1e3,
        static_cast<double>(std::filesystem::file_size(file)) / 1e6, load_ms[load_ms.size() / 2], runs,
        load_ms.front());
    std::filesystem::remove(file);
    return 0;
}
