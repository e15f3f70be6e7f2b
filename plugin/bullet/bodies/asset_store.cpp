#include "bullet/bodies/asset_store.h"

#include <algorithm>
#include <utility>

#include "geometry/mass_properties.h"
#include "geometry/solid_union.h"

namespace sherd {

namespace {

/// Functions cannot be compared.
bool hasFunctions(const Settings& settings) {
    return settings.strength.field || settings.fracture.guide.custom;
}

}  // namespace

Result<AssetStore::OfParts> AssetStore::assetOf(ConvexParts parts, double mass_kg, Material material,
                                                const Settings& settings,
                                                const std::vector<SurfaceRegion>& supports) {
    const auto is_dead = [](const Entry& entry) { return entry.asset.expired(); };
    entries_.erase(std::remove_if(entries_.begin(), entries_.end(), is_dead), entries_.end());
    const std::string constants = material.toJson() + settings.toJson();
    if (!hasFunctions(settings))
        for (const Entry& entry : entries_)
            if (const auto known = entry.asset.lock();
                known && *entry.parts == parts && entry.mass_kg == mass_kg && entry.constants == constants &&
                known->supports() == supports)
                return OfParts{used(known), entry.parts};
    const auto surface = uniteConvexParts(parts);
    if (!surface) return Error{surface.error()};
    if (mass_kg > 0) material.density_kg_m3 = mass_kg / solidMoments(surface.value()).volume;
    auto made = BreakableAsset::fromMesh(surface.value(), material, settings);
    if (made && !supports.empty()) made = made.value().anchored(supports);
    if (!made) return Error{made.error()};
    auto asset = std::make_shared<const BreakableAsset>(std::move(made).value());
    auto made_of = std::make_shared<const ConvexParts>(std::move(parts));
    if (hasFunctions(settings)) return OfParts{std::move(asset), std::move(made_of)};
    entries_.push_back({made_of, mass_kg, constants, asset});
    return OfParts{used(std::move(asset)), std::move(made_of)};
}

std::shared_ptr<const BreakableAsset> AssetStore::used(std::shared_ptr<const BreakableAsset> asset) {
    constexpr std::size_t kept = 8;
    last_used_.erase(std::remove(last_used_.begin(), last_used_.end(), asset), last_used_.end());
    if (last_used_.size() == kept) last_used_.erase(last_used_.begin());
    last_used_.push_back(asset);
    return asset;
}

}  // namespace sherd
