#include "core/clustering/clusters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <random>
#include <tuple>

#include "core/clustering/damaged_region.h"
#include "core/clustering/penalty_distance.h"
#include "core/clustering/wall_axes.h"

namespace sherd {

namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();

/// The two seeds that are nearest to a particle.
struct TwoNearest {
    double distance = unreached, second_distance = unreached;
    int label = -1, second = -1;
};

/// Distances from seeds among the damaged particles, longer where the stress is higher, so that seeds lie
/// denser there: path lengths, or with a guide field those of Eq. 18.
class StressMetric {
  public:
    StressMetric(const Discretisation& solid, const std::vector<Vec3>& axes, const Damage& damage,
                 const std::vector<char>& state, const GuideField& guide, const BlowAxis& blow)
        : solid_(solid), axes_(axes), damage_(damage), state_(state), guide_(guide), blow_(blow) {}

    /// Claims what is nearer to `source` than to all seeds before for `label`, going along the neighbour
    /// table through what it wins; beyond, as far as it comes second, it is noted as the second.
    void claim(int source, int label, std::vector<TwoNearest>& nearest) const {
        using Entry = std::tuple<double, int, bool>;  // distance, particle, whether it was won
        std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> front;
        const auto reach = [&](int i, double d, bool through_own) {
            TwoNearest& there = nearest[i];
            const bool won = through_own && d < there.distance;
            if (won && there.label != label) {
                there.second = there.label;
                there.second_distance = there.distance;
            }
            if (won) {
                there.label = label;
                there.distance = d;
            } else if (there.label != label && d < there.second_distance) {
                there.second = label;
                there.second_distance = d;
            } else {
                return;
            }
            front.push({d, i, won});
        };
        reach(source, 0, true);
        while (!front.empty()) {
            const auto [d, i, won] = front.top();
            front.pop();
            const bool outdated = won ? nearest[i].label != label || d > nearest[i].distance
                                      : nearest[i].second != label || d > nearest[i].second_distance;
            if (outdated) continue;
            for (int j : solid_.neighbours[i])
                if (state_[j])
                    reach(j, guide_.kind == GuideField::Kind::none ? d + step(i, j) : straight(source, j),
                          won);
        }
    }

  private:
    double step(int i, int j) const {
        constexpr double through_wall = 0.2;
        const double stress = 0.5 * (damage_.overstress[i] + damage_.overstress[j]);
        Vec3 offset = solid_.particles[i].position - solid_.particles[j].position;
        offset -= (1 - through_wall) * offset.dot(axes_[i]) * axes_[i];
        return offset.norm() * density(stress);
    }

    double straight(int source, int i) const {
        return penaltyDistance(solid_.particles[source].position, solid_.particles[i].position, guide_,
                               blow_) *
               density(damage_.overstress[i]);
    }

    // Cracks are paid for by the elastic energy that was there, which goes with the square of the stress:
    // pieces of edge d have crack faces of about 1 / d a volume. Right under a contact the stress is that of
    // the load's patch; it counts as `highest`, or all seeds would go there.
    static double density(double overstress) {
        constexpr double highest = 3;
        const double stress = std::clamp(overstress, 1.0, highest);
        return stress * stress;
    }

    const Discretisation& solid_;
    const std::vector<Vec3>& axes_;
    const Damage& damage_;
    const std::vector<char>& state_;
    const GuideField& guide_;
    const BlowAxis& blow_;
};

/// Seeds by farthest point, the first at random; returns them, a cluster each, labelled from `first_label`
/// on.
std::vector<int> clusterDamaged(const StressMetric& metric, const std::vector<char>& state, int clusters,
                                int first_label, std::uint64_t seed, FragmentLabels& labels) {
    std::vector<int> candidates;
    for (std::size_t i = 0; i < state.size(); ++i)
        if (state[i]) candidates.push_back(static_cast<int>(i));
    if (candidates.empty()) return {};
    std::vector<TwoNearest> nearest(state.size());
    std::mt19937_64 random(seed);
    int next = candidates[random() % candidates.size()];
    std::vector<int> seeds;
    while (true) {
        metric.claim(next, first_label + static_cast<int>(seeds.size()), nearest);
        seeds.push_back(next);
        next = *std::max_element(candidates.begin(), candidates.end(),
                                 [&](int a, int b) { return nearest[a].distance < nearest[b].distance; });
        // Beyond the wanted number only parts that no seed reaches yet get one.
        const double farthest = nearest[next].distance;
        if (farthest == 0 || (static_cast<int>(seeds.size()) >= clusters && farthest != unreached)) break;
    }
    for (const int i : candidates) {
        const TwoNearest& here = nearest[i];
        labels.of_particle[i] = here.label;
        // Linear between two seeds, and 1/2 where a particle is as near to both.
        const double both = here.distance + here.second_distance;
        if (here.second >= 0 && both > 0)
            labels.shared[i] = {here.second, std::min(0.5, here.distance / both)};
    }
    return seeds;
}

}  // namespace

int affordableClusters(const ClusterBudget& budget, double damaged_volume_m3) {
    const double area = budget.energy_j / budget.fracture_energy_j_m2;
    if (!(area > 0)) return 1;
    const double wall = budget.wall_thickness_m;
    double edge = 2 * damaged_volume_m3 / area;
    double count = damaged_volume_m3 / (edge * edge * wall);
    if (edge < wall) {
        edge = 3 * damaged_volume_m3 / area;
        count = damaged_volume_m3 / (edge * edge * edge);
    }
    return static_cast<int>(std::clamp(count, 1.0, 1e6));
}

FragmentLabels fragmentLabels(const Discretisation& solid, const Damage& damage, int clusters,
                              double wall_thickness_m, std::uint64_t seed, const GuideField& guide,
                              const BlowAxis& blow) {
    const std::vector<Vec3> axes = wallAxes(solid);
    const Damage through = damagedRegion(solid, axes, damage, wall_thickness_m);
    const std::vector<char>& state = through.damaged;
    const Parts parts = connectedParts(solid, state);
    FragmentLabels labels;
    labels.of_particle.assign(state.size(), -1);
    labels.shared.resize(state.size());
    std::vector<int> label_of_part(parts.sizes.size(), -1);
    for (std::size_t i = 0; i < state.size(); ++i) {
        if (state[i]) continue;
        int& label = label_of_part[parts.of_particle[i]];
        if (label < 0) label = labels.count++;
        labels.of_particle[i] = label;
    }
    const std::vector<int> seeds = clusterDamaged(StressMetric(solid, axes, through, state, guide, blow),
                                                  state, clusters, labels.count, seed, labels);
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
