#include "core/clustering/clusters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <random>
#include <tuple>

namespace sherd {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr double kAcrossWall = 0.75;  // of the wall, about the way between the outermost particles of two sides
constexpr int kSpeck = 3;  // parts of fewer particles are no fragments

/// Connected components of the particles with equal `state`, numbered by their first particle.
struct Parts {
    std::vector<int> of_particle;
    std::vector<int> sizes;
};

Parts connectedParts(const Discretisation& solid, const std::vector<char>& state) {
    Parts parts;
    parts.of_particle.assign(state.size(), -1);
    std::vector<int> stack;
    for (std::size_t first = 0; first < state.size(); ++first) {
        if (parts.of_particle[first] >= 0) continue;
        const int part = static_cast<int>(parts.sizes.size());
        parts.sizes.push_back(0);
        parts.of_particle[first] = part;
        stack.push_back(static_cast<int>(first));
        while (!stack.empty()) {
            const int i = stack.back();
            stack.pop_back();
            ++parts.sizes[part];
            for (int j : solid.neighbours[i]) {
                if (parts.of_particle[j] >= 0 || state[j] != state[i]) continue;
                parts.of_particle[j] = part;
                stack.push_back(j);
            }
        }
    }
    return parts;
}

/// Flips specks of either state to that of what surrounds them; a body of its own stays as it is.
std::vector<char> withoutSpecks(const Discretisation& solid, std::vector<char> state) {
    for (const char speck_state : {char(0), char(1)}) {
        const Parts parts = connectedParts(solid, state);
        std::vector<char> touches(parts.sizes.size());
        for (std::size_t i = 0; i < state.size(); ++i)
            for (int j : solid.neighbours[i])
                touches[parts.of_particle[i]] |= parts.of_particle[j] != parts.of_particle[i];
        for (std::size_t i = 0; i < state.size(); ++i) {
            const int part = parts.of_particle[i];
            if (state[i] == speck_state && parts.sizes[part] < kSpeck && touches[part]) state[i] = !state[i];
        }
    }
    return state;
}

/// Takes in what lies within `reach` of damaged particles along the neighbour table: in a wall a crack that starts on one
/// side runs through to the other, it does not turn and peel the wall.
std::vector<char> spread(const Discretisation& solid, const std::vector<char>& damaged, double reach) {
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> front;
    std::vector<double> distance(damaged.size(), kFar);
    for (std::size_t i = 0; i < damaged.size(); ++i) {
        if (!damaged[i]) continue;
        distance[i] = 0;
        front.push({0, static_cast<int>(i)});
    }
    std::vector<char> reached = damaged;
    while (!front.empty()) {
        const auto [d, i] = front.top();
        front.pop();
        if (d > distance[i]) continue;
        reached[i] = 1;
        for (int j : solid.neighbours[i]) {
            const double further = d + (solid.particles[i].position - solid.particles[j].position).norm();
            if (further >= distance[j] || further > reach) continue;
            distance[j] = further;
            front.push({further, j});
        }
    }
    return reached;
}

/// The two seeds that are nearest to a particle.
struct TwoNearest {
    double distance = kFar, second_distance = kFar;
    int label = -1, second = -1;
};

/// Distances from seeds among the damaged particles, longer where the stress is higher, so that seeds lie denser there:
/// path lengths, or with a guide field those of Eq. 18.
class StressMetric {
  public:
    StressMetric(const Discretisation& solid, const Damage& damage, const std::vector<char>& state,
                 const GuideField& guide, const BlowAxis& blow)
        : solid_(solid), damage_(damage), state_(state), guide_(guide), blow_(blow) {}

    /// Claims what is nearer to `source` than to all seeds before for `label`, going along the neighbour table through
    /// what it wins; beyond, as far as it comes second, it is noted as the second.
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
                    reach(j, guide_.kind == GuideField::Kind::none ? d + step(i, j) : straight(source, j), won);
        }
    }

  private:
    double step(int i, int j) const {
        const double stress = 0.5 * (damage_.overstress[i] + damage_.overstress[j]);
        return (solid_.particles[i].position - solid_.particles[j].position).norm() * density(stress);
    }

    double straight(int source, int i) const {
        return penaltyDistance(solid_.particles[source].position, solid_.particles[i].position, guide_, blow_) *
               density(damage_.overstress[i]);
    }

    static double density(double overstress) { return std::sqrt(std::max(1.0, overstress)); }

    const Discretisation& solid_;
    const Damage& damage_;
    const std::vector<char>& state_;
    const GuideField& guide_;
    const BlowAxis& blow_;
};

/// Seeds by farthest point, the first at random; returns the number of clusters made.
int clusterDamaged(const StressMetric& metric, const std::vector<char>& state, int clusters, int first_label,
                   std::uint64_t seed, FragmentLabels& labels) {
    std::vector<int> candidates;
    for (std::size_t i = 0; i < state.size(); ++i)
        if (state[i]) candidates.push_back(static_cast<int>(i));
    if (candidates.empty()) return 0;
    std::vector<TwoNearest> nearest(state.size());
    std::mt19937_64 random(seed);
    int next = candidates[random() % candidates.size()];
    int made = 0;
    while (true) {
        metric.claim(next, first_label + made, nearest);
        ++made;
        next = *std::max_element(candidates.begin(), candidates.end(), [&](int a, int b) {
            return nearest[a].distance < nearest[b].distance;
        });
        // Beyond the wanted number only parts that no seed reaches yet get one.
        const double farthest = nearest[next].distance;
        if (farthest == 0 || (made >= clusters && farthest != kFar)) break;
    }
    for (const int i : candidates) {
        const TwoNearest& here = nearest[i];
        labels.of_particle[i] = here.label;
        // Linear between two seeds, and 1/2 where a particle is as near to both.
        const double both = here.distance + here.second_distance;
        if (here.second >= 0 && both > 0) labels.shared[i] = {here.second, std::min(0.5, here.distance / both)};
    }
    return made;
}

}  // namespace

double penaltyDistance(const Vec3& a, const Vec3& b, const GuideField& guide, const BlowAxis& blow) {
    const Vec3 middle = 0.5 * (a + b);
    Vec3 offset = b - a;
    const auto penalise = [&](const Vec3& field) {
        if (!field.allFinite() || field.isZero(0)) return;
        const Vec3 v = field.normalized();
        offset -= (1 - guide.penalty) * offset.dot(v) * v;
    };
    switch (guide.kind) {
        case GuideField::Kind::none:
            break;
        case GuideField::Kind::constant:
            penalise(guide.direction);
            break;
        case GuideField::Kind::radial: {
            const Vec3 away = middle - blow.contact;
            penalise(away - away.dot(blow.direction) * blow.direction);
            penalise(blow.direction);
            break;
        }
        case GuideField::Kind::custom:
            penalise(guide.custom(middle, blow.contact));
            break;
    }
    return offset.norm();
}

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
    const std::vector<char> damaged =
        spread(solid, withoutSpecks(solid, damage.damaged), kAcrossWall * wall_thickness_m);
    const std::vector<char> state = withoutSpecks(solid, damaged);
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
    labels.count += clusterDamaged(StressMetric(solid, damage, state, guide, blow), state, clusters, labels.count,
                                   seed, labels);
    return labels;
}

}  // namespace sherd
