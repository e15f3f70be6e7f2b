#include "core/clustering/clusters.h"

#include <algorithm>
#include <limits>
#include <random>

#include "core/clustering/damaged_region.h"
#include "core/clustering/nearest_seeds.h"
#include "core/clustering/penalty_distance.h"
#include "core/clustering/wall_axes.h"

namespace sherd {

namespace {

/// Spreads seeds over the damaged particles by farthest point, the first at random, until there are
/// `clusters` and each connected damaged part has one. Returns their particles, and what is nearest to each
/// particle with clusters labelled from `first_label` on.
std::vector<int> spreadSeeds(const SeedDistances& distances, const std::vector<int>& damaged, int clusters,
                             int first_label, std::uint64_t random_seed, std::vector<TwoNearest>& nearest) {
    std::mt19937_64 random(random_seed);
    std::vector<int> seeds;
    int next = damaged[random() % damaged.size()];
    while (true) {
        distances.addSeed(next, first_label + static_cast<int>(seeds.size()), nearest);
        seeds.push_back(next);
        next = *std::max_element(damaged.begin(), damaged.end(),
                                 [&](int a, int b) { return nearest[a].distance < nearest[b].distance; });
        const double farthest = nearest[next].distance;
        const bool all_reached = farthest != std::numeric_limits<double>::infinity();
        if (farthest == 0 || (static_cast<int>(seeds.size()) >= clusters && all_reached)) return seeds;
    }
}

/// Labels the damaged particles by their nearest seeds and notes the runners-up. The share of a runner-up is
/// linear between two seeds, and 1/2 where a particle is as near to both.
void labelByNearest(const std::vector<int>& damaged, const std::vector<TwoNearest>& nearest,
                    FragmentLabels& labels) {
    for (const int i : damaged) {
        const TwoNearest& here = nearest[i];
        labels.of_particle[i] = here.label;
        const double both = here.distance + here.second_distance;
        if (here.second_label >= 0 && both > 0)
            labels.runner_up[i] = {here.second_label, std::min(0.5, here.distance / both)};
    }
}

}  // namespace

FragmentLabels clusterParticles(const Discretisation& solid, const Damage& damage, int clusters,
                                double wall_thickness_m, std::uint64_t seed, const GuideField& guide,
                                const BlowAxis& blow) {
    const std::vector<Vec3> axes = wallAxes(solid);
    const Damage region = damagedRegion(solid, axes, damage, wall_thickness_m);
    FragmentLabels labels;
    labels.runner_up.resize(region.damaged.size());
    const std::vector<int> damaged = labelWholeParts(solid, region.damaged, labels);
    std::vector<int> seeds;
    if (!damaged.empty()) {
        std::vector<TwoNearest> nearest(region.damaged.size());
        seeds = spreadSeeds(SeedDistances(solid, axes, region, guide, blow), damaged, clusters, labels.count,
                            seed, nearest);
        labelByNearest(damaged, nearest, labels);
    }
    if (guide.kind != GuideField::Kind::none) {
        labels.distance = [guide, blow](const Vec3& a, const Vec3& x) {
            return penaltyDistance(a, x, guide, blow);
        };
        for (const int i : seeds) labels.seeds.push_back(solid.particles[i].position);
        for (const int label : labels.of_particle)
            labels.cluster.push_back(std::max(-1, label - labels.count));
    }
    labels.count += static_cast<int>(seeds.size());
    return labels;
}

}  // namespace sherd
