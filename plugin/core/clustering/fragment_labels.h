#pragma once

#include <sherd/types.h>

#include <functional>
#include <vector>

namespace sherd {

/// How much of the material around a particle belongs to the fragment that is the second nearest.
struct SharedLabel {
    int second = -1;   ///< or -1: all is the particle's own
    double share = 0;  ///< 0 where nothing is, 1/2 where both are equally near
};

/// Which fragment every particle belongs to.
struct FragmentLabels {
    std::vector<int> of_particle;  ///< #particles, 0 <= label < count
    int count = 0;
    /// #particles, or empty. They place a crack between two fragments to a fraction of the particle spacing.
    std::vector<SharedLabel> shared;
    /// Where a guide field shaped the fragments: how far any point is from a seed, m, the seeds of the
    /// clusters, and the cluster of each particle (#particles; -1: not damaged), which may have been merged
    /// with others into a fragment; or all empty. They place cracks exactly, between particles too.
    std::function<double(const Vec3& seed, const Vec3& x)> distance;
    std::vector<Vec3> seeds;
    std::vector<int> cluster;

    SharedLabel sharedAt(int particle) const { return shared.empty() ? SharedLabel{} : shared[particle]; }
};

}  // namespace sherd
