#include "prototype/baking.h"

#include <chrono>
#include <filesystem>
#include <utility>

namespace prototype {
namespace {

using Progress = std::function<void(double)>;
using sherd::BreakableAsset;

sherd::Result<BreakableAsset> assetOf(const Kind& kind) {
    auto asset = BreakableAsset::fromMesh(kind.surface, kind.material, kind.settings);
    if (asset && !kind.supports.empty()) asset = asset.value().anchored(kind.supports);
    return asset;
}

sherd::Status bake(const BreakableAsset& asset, const std::string& file, const Progress& progress) {
    const sherd::Status prepared = asset.prepare(progress);
    return prepared ? asset.save(file) : prepared;
}

sherd::Result<ReadyLevel> getReady(const std::string& folder, const Progress& progress) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed) return sherd::Error{"The folder " + folder + " cannot be made: " + failed.message() + "."};
    auto level = makeLevel(folder);
    if (!level) return sherd::Error{level.error()};
    ReadyLevel ready{std::move(level).value(), {}, 0};
    const std::size_t count = ready.level.kinds.size();
    for (std::size_t i = 0; i < count; ++i) {
        const auto some = [&](double done) { progress((double(i) + done) / double(count)); };
        const Kind& kind = ready.level.kinds[i];
        const std::string file = folder + "/" + kind.name + ".sherd";
        const auto made = assetOf(kind);
        if (!made) return sherd::Error{kind.name + ": " + made.error()};
        const auto loaded = BreakableAsset::load(file);
        const bool is_ready = loaded && loaded.value().isSameAs(made.value());
        if (!is_ready) {
            if (const auto baked = bake(made.value(), file, some); !baked)
                return sherd::Error{kind.name + ": " + baked.error()};
            ++ready.baked;
        }
        ready.assets.push_back(is_ready ? loaded.value() : made.value());
        some(1);
    }
    return ready;
}

}  // namespace

Baking::Baking(const std::string& folder)
    : future_(std::async(std::launch::async, [folder, share = share_] {
          return getReady(folder, [share](double done) { *share = float(done); });
      })) {}

bool Baking::done() const {
    return future_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace prototype
