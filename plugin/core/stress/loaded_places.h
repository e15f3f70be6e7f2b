#pragma once

#include <sherd/types.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/sampling/discretisation.h"

namespace sherd {

/// Which points lie near a load. The loads are sorted into cubes as long as `reach`, so that a point is held
/// against those around it only.
class LoadedPlaces {
  public:
    LoadedPlaces(const std::vector<PointForce>& acting, double reach) : reach_(reach) {
        for (const PointForce& load : acting) {
            box_.extend(load.position);
            loads_.push_back({cubeOf(load.position), load.position});
        }
        std::sort(loads_.begin(), loads_.end(), [](const Load& a, const Load& b) { return a.cube < b.cube; });
    }

    bool isNear(const Vec3& x) const {
        if (loads_.empty() || box_.squaredExteriorDistance(x) > reach_ * reach_) return false;
        const Cube middle = cubeOf(x);
        for (std::int64_t i = -1; i <= 1; ++i)
            for (std::int64_t j = -1; j <= 1; ++j) {
                // The cubes of a row follow each other.
                const Cube first{middle[0] + i, middle[1] + j, middle[2] - 1},
                    last{first[0], first[1], middle[2] + 1};
                auto load = std::lower_bound(loads_.begin(), loads_.end(), first,
                                             [](const Load& a, const Cube& cube) { return a.cube < cube; });
                for (; load != loads_.end() && load->cube <= last; ++load)
                    if ((load->position - x).squaredNorm() < reach_ * reach_) return true;
            }
        return false;
    }

  private:
    using Cube = std::array<std::int64_t, 3>;
    struct Load {
        Cube cube;
        Vec3 position;
    };

    Cube cubeOf(const Vec3& x) const {
        const auto index = [&](int d) { return static_cast<std::int64_t>(std::floor(x[d] / reach_)); };
        return {index(0), index(1), index(2)};
    }

    double reach_;
    Eigen::AlignedBox3d box_;
    std::vector<Load> loads_;
};

}  // namespace sherd
