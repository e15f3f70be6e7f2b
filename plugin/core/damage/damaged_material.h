#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/sampling/discretisation.h"

namespace sherd {

/// What blows damaged of a body that did not come apart, in the coordinates of the body that was whole at
/// first: sub-domains of damaged particles, as the voxels that they are made of. So other grids, those of
/// fragments, find it too. Never changes.
class DamagedMaterial {
  public:
    /// `earlier` (may be null) and the sub-domains of the particles that are `damaged` (#particles).
    static std::shared_ptr<const DamagedMaterial> with(const std::shared_ptr<const DamagedMaterial>& earlier,
                                                       const Discretisation& sampling,
                                                       const std::vector<char>& damaged);
    /// All that either of them holds; each may be null.
    static std::shared_ptr<const DamagedMaterial> united(const std::shared_ptr<const DamagedMaterial>& a,
                                                         const std::shared_ptr<const DamagedMaterial>& b);

    bool contains(const Vec3& x) const;  ///< m

    /// 1 for particles of which at least half is damaged (#particles). Those of the sampling that it was made
    /// with come out as they went in.
    std::vector<char> particles(const Discretisation& sampling) const;

  private:
    /// Voxels of one grid.
    struct Voxels {
        Vec3 origin, size;                           ///< m
        std::vector<std::array<int, 3>> of_damaged;  ///< sorted

        bool isOn(const Voxels& grid) const { return origin == grid.origin && size == grid.size; }
        bool contains(const Vec3& x) const;
    };
    void add(const Voxels& more);

    std::vector<Voxels> grids_;
};

}  // namespace sherd
