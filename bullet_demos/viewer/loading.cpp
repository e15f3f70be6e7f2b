#include "viewer/loading.h"

#include <algorithm>
#include <utility>

#include "scenes/scene_file.h"
#include "viewer/left_over.h"
#include "viewer/own_mesh.h"

namespace demo {
namespace {

sherd::Result<Loaded> loadScene(const Choices& choices, const std::string& meshes) {
    auto scene = readScene(choices.file, choices.preset, choices.changes);
    if (!scene) return sherd::Error{scene.error()};
    Loaded loaded{std::move(scene).value(), {}, {}};
    const sherd::Status chosen = chooseMaterials(loaded.scene, choices);
    if (!chosen) return sherd::Error{chosen.error()};
    auto assets = makeAssets(loaded.scene, meshes,
                             [&loaded](const std::string& sentence) { loaded.said.push_back(sentence); });
    if (!assets) return sherd::Error{assets.error()};
    loaded.assets = std::move(assets).value();
    return loaded;
}

}  // namespace

sherd::Result<Loaded> load(const Choices& choices, const std::string& meshes) {
    return choices.isScene() ? loadScene(choices, meshes) : loadOwnMesh(choices);
}

Loading::Loading(const Choices& choices, const std::string& meshes)
    : future_(std::async(std::launch::async, [choices, meshes] { return load(choices, meshes); })) {}

Loading::~Loading() {
    leaveToItself(std::move(future_));
}

bool Loading::done() const {
    return isReady(future_);
}

Preparation::Preparation(const SceneAssets& assets) {
    for (const sherd::BreakableAsset& asset : assets.bodies) {
        auto share = std::make_shared<std::atomic<float>>(0.0f);
        // At the priority of a program that somebody waits for: prepareOnThread would wait for idle cores.
        threads_.push_back(std::async(std::launch::async, [asset, share] {
            return asset.prepare([share](double done) { *share = float(done); });
        }));
        shares_.push_back(std::move(share));
    }
}

Preparation::~Preparation() {
    for (auto& thread : threads_) leaveToItself(std::move(thread));
}

bool Preparation::done() const {
    return std::all_of(threads_.begin(), threads_.end(), [](const auto& thread) { return isReady(thread); });
}

float Preparation::share() const {
    float sum = 0;
    for (const auto& share : shares_) sum += *share;
    return shares_.empty() ? 1 : sum / float(shares_.size());
}

}  // namespace demo
