#pragma once

#include <sherd/breakable_asset.h>

#include <memory>
#include <string>
#include <vector>

#include "bullet/shapes/shapes.h"

namespace sherd {

/// The assets of bodies that the app made itself: those that are alike share one, so the blocks of a wall are
/// sampled, factored and prepared together. It stays for as long as somebody keeps it, and the last eight
/// that were asked for stay in any case: the crates of the next level are not prepared again.
class AssetStore {
  public:
    /// An asset, and what it was made of.
    struct OfParts {
        std::shared_ptr<const BreakableAsset> asset;
        std::shared_ptr<const ConvexParts> parts;
    };

    /// The union of convex parts, as BreakableAsset::fromMesh has it; anchored, if there are supports. The
    /// density follows from the mass; where that is 0 the material says it.
    Result<OfParts> assetOf(ConvexParts parts, double mass_kg, Material material, const Settings& settings,
                            const std::vector<SurfaceRegion>& supports);

  private:
    struct Entry {
        std::shared_ptr<const ConvexParts> parts;
        double mass_kg = 0;
        std::string constants;
        std::weak_ptr<const BreakableAsset> asset;
    };
    std::shared_ptr<const BreakableAsset> used(std::shared_ptr<const BreakableAsset> asset);

    std::vector<Entry> entries_;
    std::vector<std::shared_ptr<const BreakableAsset>> last_used_;  // the latest at the end
};

}  // namespace sherd
