#pragma once

#include <sherd/types.h>

#include <functional>
#include <memory>
#include <vector>

#include "core/clustering/crack_tree.h"

namespace sherd {

/// The label whose seed is second nearest to a particle, and how much of the particle's material counts as
/// that label's.
struct RunnerUp {
    int label = -1;    ///< -1 if there is none
    double share = 0;  ///< from 0 to 1/2, where both seeds are equally near
};

/// A label for every particle. Particles of one label become one piece of the surface, or several where they
/// come apart in the cut; each piece becomes a fragment.
struct FragmentLabels {
    std::vector<int> of_particle;  ///< #particles, 0 <= label < count
    int count = 0;
    /// #particles, or empty. Shares place a crack between two labels to a fraction of the particle
    /// spacing.
    std::vector<RunnerUp> runner_up;

    // With a guide field, which gives a distance between any two points and so places cracks exactly between
    // particles too; else empty.
    std::function<double(const Vec3& seed, const Vec3& x)> distance;  ///< m
    std::vector<Vec3> seeds;                                          ///< of the clusters, m
    std::vector<int> cluster;  ///< #particles; several may have been merged under a label; -1: undamaged

    // With crack planes, which place cracks exactly too; else empty.
    std::shared_ptr<const CrackTree> cracks;
    std::vector<int> part;  ///< #particles, of the tree; several may have been merged under a label

    RunnerUp runnerUpOf(int particle) const { return runner_up.empty() ? RunnerUp{} : runner_up[particle]; }
};

}  // namespace sherd
