#include "prototype/baking.h"

#include <chrono>
#include <filesystem>
#include <utility>

namespace prototype {
namespace {

using Progress = std::function<void(double)>;
using sherd::BreakableAsset;

std::vector<std::string> described(const std::vector<sherd::SurfaceRegion>& regions) {
    std::vector<std::string> sentences;
    for (const sherd::SurfaceRegion& region : regions) sentences.push_back(sherd::describe(region));
    return sentences;
}

bool isStill(const BreakableAsset& asset, const Kind& kind) {
    const sherd::TriangleMesh& surface = asset.surface();
    return surface.vertices == kind.surface.vertices && surface.triangles == kind.surface.triangles &&
           asset.material().toJson() == kind.material.toJson() &&
           asset.settings().toJson() == kind.settings.toJson() &&
           described(asset.supports()) == described(kind.supports);
}

sherd::Result<BreakableAsset> bake(const Kind& kind, const std::string& file, const Progress& progress) {
    auto asset = BreakableAsset::fromMesh(kind.surface, kind.material, kind.settings);
    if (asset && !kind.supports.empty()) asset = asset.value().anchored(kind.supports);
    if (!asset) return sherd::Error{kind.name + ": " + asset.error()};
    const sherd::Status prepared = asset.value().prepare(progress);
    if (!prepared) return sherd::Error{kind.name + ": " + prepared.error()};
    const sherd::Status saved = asset.value().save(file);
    if (!saved) return sherd::Error{saved.error()};
    return asset;
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
        auto asset = BreakableAsset::load(file);
        if (!asset || !isStill(asset.value(), kind)) {
            asset = bake(kind, file, some);
            ++ready.baked;
        }
        if (!asset) return sherd::Error{asset.error()};
        ready.assets.push_back(std::move(asset).value());
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
