#include "world/scene_assets.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "generators/mesh_store.h"
#include "scenes/box_mesh.h"

namespace demo {
namespace {

using Announce = std::function<void(const std::string&)>;

/// A sentence about a mesh, with what a scene file says in the place of the fields of Repair that it names.
std::string inSceneWords(const std::string& sentence) {
    return sherd::withNames(sentence, {{"Repair::automatic()", "\"repair\": \"automatic\""},
                                       {"Repair::scale", "\"scale\""},
                                       {"Repair::shell_thickness_m", "\"shell_thickness_m\""},
                                       {"Repair::wrap_detail", "\"wrap_detail\""}});
}

/// Reads and repairs it as the scene says; what was changed, and a size that is hardly meant, is announced.
sherd::Result<sherd::TriangleMesh> readMesh(const ObjFile& file, const Announce& announce) {
    const auto mesh = sherd::readObj(file.path);
    if (!mesh) return mesh;
    auto repaired = sherd::repairMesh(mesh.value(), file.repair);
    if (!repaired) return sherd::Error{file.path + ": " + inSceneWords(repaired.error())};
    std::vector<std::string> said = repaired.value().report.sentences();
    said.push_back(sherd::sizeWarning(repaired.value().mesh));
    for (const std::string& sentence : said)
        if (announce && !sentence.empty()) announce(file.path + ": " + inSceneWords(sentence));
    return std::move(repaired.value().mesh);
}

sherd::Result<sherd::TriangleMesh> makeSurface(const Shape& shape, const std::string& meshes,
                                               const Announce& announce) {
    if (const auto* box = std::get_if<Box>(&shape)) return boxMesh(*box);
    if (const auto* mesh = std::get_if<Generated>(&shape))
        return storedMesh(mesh->name, mesh->triangles, meshes, announce);
    return readMesh(std::get<ObjFile>(shape), announce);
}

/// The body's settings, with the strength that its surface is painted with.
sherd::Result<sherd::Settings> makeSettings(const BreakableBody& body, const sherd::TriangleMesh& surface) {
    sherd::Settings settings = body.settings;
    if (!body.painted_strength) return settings;
    const PaintedStrength& painted = *body.painted_strength;
    auto strength = sherd::strengthFromColours(surface, painted.black, painted.white);
    if (!strength) return sherd::Error{"painted_strength: " + strength.error()};
    settings.strength.field = std::move(strength).value();
    settings.strength.field_minimum = std::min(painted.black, painted.white);
    return settings;
}

sherd::Result<sherd::BreakableAsset> makeAsset(const BreakableBody& body, const std::string& meshes,
                                               const Announce& announce, double& sample_ms) {
    const auto surface = makeSurface(body.shape, meshes, announce);
    if (!surface) return sherd::Error{surface.error()};
    const auto* file = std::get_if<ObjFile>(&body.shape);
    const std::string source = file ? file->path + ": " : "";
    const auto settings = makeSettings(body, surface.value());
    if (!settings) return sherd::Error{source + settings.error()};
    auto asset = sherd::BreakableAsset::fromMesh(surface.value(), body.material, settings.value());
    if (!asset) return sherd::Error{source + asset.error()};
    const auto start = std::chrono::steady_clock::now();
    const bool is_sampled = asset.value().particleCount() > 0;
    sample_ms += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    // A solid that cannot be sampled gets no body in the world; `prepare` says why, before it assembles
    // anything.
    if (!is_sampled) return sherd::Error{source + asset.value().prepare().error()};
    if (body.supports.empty()) return asset;
    auto anchored = asset.value().anchored(body.supports);
    if (!anchored) return sherd::Error{source + anchored.error()};
    return anchored;
}

}  // namespace

sherd::Result<SceneAssets> makeAssets(const Scene& scene, const std::string& meshes,
                                      const Announce& announce) {
    SceneAssets assets;
    for (const BreakableBody& body : scene.bodies) {
        auto asset = makeAsset(body, meshes, announce, assets.sample_ms);
        if (!asset) return sherd::Error{asset.error()};
        assets.bodies.push_back(std::move(asset).value());
    }
    return assets;
}

}  // namespace demo
