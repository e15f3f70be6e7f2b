#pragma once

#include <sherd/breakable_asset.h>

#include <memory>
#include <string>
#include <vector>

namespace sherd {

/// The assets of bodies that the app made itself: those that are alike share one for as long as somebody
/// keeps it. So the blocks of a wall are sampled, factored and prepared together.
class AssetStore {
  public:
    /// As BreakableAsset::fromMesh; anchored, if there are supports.
    Result<std::shared_ptr<const BreakableAsset>> assetOf(const TriangleMesh& surface,
                                                          const Material& material, const Settings& settings,
                                                          const std::vector<SurfaceRegion>& supports);

  private:
    struct Entry {
        std::string constants;
        std::weak_ptr<const BreakableAsset> asset;
    };
    std::vector<Entry> entries_;
};

}  // namespace sherd
