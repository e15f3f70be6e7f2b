// What a baked asset takes: bake_benchmark FILE.obj [PRESET [RUNS [BLOWS]]]. Prints seconds to make it, to
// save it and to prepare the same in memory, megabytes of the file, and milliseconds to load it, the file
// being cached; then the stages of blows on the loaded asset, of one contact each, that reach its reduced
// model and hold: medians in milliseconds, and the highest tenth of stress and damage together. Each blow is
// the fastest of five times: what else the machine does only adds to it.

#include <sherd/breakable_asset.h>
#include <sherd/fields.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <vector>

#include "benchmark/quantile.h"
#include "benchmark/value_or_exit.h"
#include "core/numerics/stopwatch.h"
#include "fracture/blow_damage.h"
#include "fracture/can_break.h"
#include "fracture/random_blows.h"

namespace {

using namespace sherd;
using namespace sherd::benchmarks;

double timeToLoad(const std::string& file) {
    const Stopwatch watch;
    valueOrExit(BreakableAsset::load(file));
    return watch.milliseconds();
}

void printLoading(const std::string& file, int runs) {
    std::vector<double> ms;
    for (int run = 0; run < runs; ++run) ms.push_back(timeToLoad(file));
    std::printf("%.2f MB; loaded in %.1f ms (median of %d; %.1f the first, %.1f the least)\n",
                static_cast<double>(std::filesystem::file_size(file)) / 1e6, median(ms), runs, ms.front(),
                *std::min_element(ms.begin(), ms.end()));
}

/// What deciding a blow takes, the fastest of a few; nothing if it is not the reduced model that lets the
/// body hold.
std::optional<StageTimes> timesOfHeld(const BreakableSolid& solid, const Blow& blow) {
    constexpr int times = 5;
    const Discretisation& sampling = *valueOrExit(solid.discretisation());
    const FractureSettings& fracture = solid.settings().fracture;
    std::optional<StageTimes> fastest;
    for (int time = 0; time < times; ++time) {
        StageTimes ms;
        if (!timed(ms.gate, [&] { return canBreak(solid, blow, fracture); })) return {};
        const BlowDamage found = blowDamage({solid, sampling, fracture, 1}, blow, solid.strength(), ms);
        if (found.level != Level::reduced || found.damage.count > 0) return {};
        if (!fastest || ms.total() < fastest->total()) fastest = ms;
    }
    return fastest;
}

void printBlows(const BreakableAsset& asset, int count) {
    fracture_tests::RandomBlows random(asset.surface(), 5);
    std::vector<double> gate, loads, solve, damage, both;
    for (int i = 0; i < count; ++i) {
        Blow blow = random.next();
        blow.contacts.resize(1);
        const auto ms = timesOfHeld(*asset.solid(), blow);
        if (!ms) continue;
        gate.push_back(ms->gate);
        loads.push_back(ms->loads);
        solve.push_back(ms->solve);
        damage.push_back(ms->damage);
        both.push_back(ms->solve + ms->damage);
    }
    std::printf(
        "%zu of %d blows: gate %.3f, loads %.3f, solve %.2f, damage %.2f; stress and damage %.2f ms (%.2f "
        "highest tenth)\n",
        both.size(), count, median(gate), median(loads), median(solve), median(damage), median(both),
        quantile(both, 0.9));
}

}  // namespace

int main(int argc, char** argv) {
    const auto quality = valueNamed<Quality>(argc > 2 ? argv[2] : "game");
    if (argc < 2 || !quality) {
        std::fprintf(stderr, "usage: bake_benchmark FILE.obj [PRESET [RUNS [BLOWS]]]; the presets are %s\n",
                     listOf(namesInFiles<Quality>()).c_str());
        return 1;
    }
    const int runs = argc > 3 ? std::max(1, std::atoi(argv[3])) : 30;
    const int blows = argc > 4 ? std::atoi(argv[4]) : 400;
    const std::string file = (std::filesystem::temp_directory_path() / "sherd_bake_benchmark.sherd").string();

    Stopwatch watch;
    const BreakableAsset asset =
        valueOrExit(BreakableAsset::fromObj(argv[1], Material::ceramic(), Settings::forQuality(*quality)));
    const double made_ms = watch.milliseconds();
    watch = {};
    succeedOrExit(asset.prepare());
    const double prepared_ms = watch.milliseconds();
    watch = {};
    succeedOrExit(asset.save(file));
    std::printf("%d particles; made in %.2f s, prepared in %.2f s, saved in %.2f s; ", asset.particleCount(),
                made_ms / 1e3, prepared_ms / 1e3, watch.milliseconds() / 1e3);
    printLoading(file, runs);
    printBlows(valueOrExit(BreakableAsset::load(file)), blows);
    std::filesystem::remove(file);
}
