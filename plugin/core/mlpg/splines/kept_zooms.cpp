#include "core/mlpg/splines/kept_zooms.h"

#include <algorithm>

namespace sherd {

std::shared_ptr<const ZoomGrid> KeptZooms::find(const Key& key) {
    const std::lock_guard lock(mutex_);
    const auto found =
        std::find_if(kept_.begin(), kept_.end(), [&](const Kept& kept) { return kept.key == key; });
    if (found == kept_.end()) return nullptr;
    std::rotate(found, found + 1, kept_.end());
    return kept_.back().grid;
}

void KeptZooms::keep(const Key& key, const std::shared_ptr<const ZoomGrid>& grid) {
    const std::lock_guard lock(mutex_);
    kept_.push_back({key, grid});
    long long entries = 0;
    for (const Kept& kept : kept_) entries += kept.grid->entries();
    for (; kept_.size() > 1 && entries > largest_entries_; kept_.erase(kept_.begin()))
        entries -= kept_.front().grid->entries();
}

Result<std::shared_ptr<const ZoomGrid>> KeptZooms::at(const Path& path,
                                                      const std::function<Result<ZoomGrid>()>& make) {
    Key key;
    for (const CellBox& box : path)
        for (const Eigen::Vector3i& corner : {box.lower, box.upper})
            key.insert(key.end(), corner.data(), corner.data() + 3);
    if (auto grid = find(key)) return grid;
    // Without the lock: others may go on meanwhile, and two that make the same make it equal.
    Result<ZoomGrid> made = make();
    if (!made) return Error{made.error()};
    const auto grid = std::make_shared<const ZoomGrid>(std::move(made).value());
    keep(key, grid);
    return grid;
}

}  // namespace sherd
