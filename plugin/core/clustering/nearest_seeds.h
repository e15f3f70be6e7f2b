#pragma once

#include <sherd/settings.h>

#include <limits>
#include <vector>

#include "core/damage/damage.h"
#include "core/loads/blow.h"
#include "core/sampling/discretisation.h"

namespace sherd {

/// The two seeds that are nearest to a particle, by the labels of their clusters; -1 where there is none.
struct TwoNearest {
    int label = -1, second_label = -1;
    double distance = std::numeric_limits<double>::infinity();
    double second_distance = std::numeric_limits<double>::infinity();
};

/// Distances from seeds to damaged particles. They are stretched where the stress is high, so that seeds
/// spread by farthest point lie denser there: path lengths along the neighbour table, or with a guide field
/// those of Eq. 18.
class SeedDistances {
  public:
    /// `wall_axes`: see wall_axes.h; the damaged particles are those of `damage`. Keeps references to all.
    SeedDistances(const Discretisation& solid, const std::vector<Vec3>& wall_axes, const Damage& damage,
                  const GuideField& guide, const BlowAxis& blow)
        : solid_(solid), axes_(wall_axes), damage_(damage), guide_(guide), blow_(blow) {}

    /// Dijkstra's algorithm from a new seed: updates the nearest and the second-nearest seed of each
    /// particle. A cluster grows through its own particles only, so that it is connected along the neighbour
    /// table.
    void addSeed(int particle, int label, std::vector<TwoNearest>& nearest) const;

  private:
    double distanceTo(int particle, int seed, int previous, double distance_of_previous) const;
    double pathStep(int i, int j) const;
    double guidedDistance(int seed, int particle) const;

    const Discretisation& solid_;
    const std::vector<Vec3>& axes_;
    const Damage& damage_;
    const GuideField& guide_;
    const BlowAxis& blow_;
};

}  // namespace sherd
