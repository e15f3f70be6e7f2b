#pragma once

#include <functional>
#include <mutex>

#include "core/mlpg/splines/zoom.h"

namespace sherd {

/// Finer grids at places that belong to a body, kept with their factors from blow to blow. May be used from
/// several threads at once.
class KeptZooms {
  public:
    /// When all hold more numbers than that, what was not used for longest is dropped.
    explicit KeptZooms(long long largest_entries) : largest_entries_(largest_entries) {}

    /// Boxes from the body's own grid inward, each in cells of the grid before it.
    using Path = std::vector<CellBox>;

    /// The grid inside the last box of a path; where it is not kept `make` makes it.
    Result<std::shared_ptr<const ZoomGrid>> at(const Path& path,
                                               const std::function<Result<ZoomGrid>()>& make);

  private:
    using Key = std::vector<int>;
    struct Kept {
        Key key;
        std::shared_ptr<const ZoomGrid> grid;
    };
    std::shared_ptr<const ZoomGrid> find(const Key& key);
    void keep(const Key& key, const std::shared_ptr<const ZoomGrid>& grid);

    std::mutex mutex_;
    std::vector<Kept> kept_;  // what was used last is at the end
    long long largest_entries_;
};

}  // namespace sherd
