#include "bullet/asset_store.h"

#include <algorithm>
#include <utility>

namespace sherd {

namespace {

/// Functions cannot be compared.
bool hasFunctions(const Settings& settings) {
    return settings.strength.field || settings.fracture.guide.custom;
}

bool areEqual(const TriangleMesh& a, const TriangleMesh& b) {
    return a.vertices == b.vertices && a.triangles == b.triangles;
}

}  // namespace

Result<std::shared_ptr<const BreakableAsset>> AssetStore::assetOf(
    const TriangleMesh& surface, const Material& material, const Settings& settings,
    const std::vector<SurfaceRegion>& supports) {
    const auto is_dead = [](const Entry& entry) { return entry.asset.expired(); };
    entries_.erase(std::remove_if(entries_.begin(), entries_.end(), is_dead), entries_.end());
    const std::string constants = material.toJson() + settings.toJson();
    if (!hasFunctions(settings))
        for (const Entry& entry : entries_)
            if (const auto known = entry.asset.lock(); known && entry.constants == constants &&
                                                       known->supports() == supports &&
                                                       areEqual(known->surface(), surface))
                return known;
    auto made = BreakableAsset::fromMesh(surface, material, settings);
    if (made && !supports.empty()) made = made.value().anchored(supports);
    if (!made) return Error{made.error()};
    auto asset = std::make_shared<const BreakableAsset>(std::move(made).value());
    if (!hasFunctions(settings)) entries_.push_back({constants, asset});
    return std::shared_ptr<const BreakableAsset>(std::move(asset));
}

}  // namespace sherd
