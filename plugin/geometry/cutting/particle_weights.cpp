#include "geometry/cutting/particle_weights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace sherd {

namespace {

// Density of the own label over the next one that a particle should have; beside a flat crack it is about 2.
constexpr double winning_ratio = 1.5;
constexpr double largest_raise = 30;
constexpr double most_at_once = 3;
constexpr int raising_rounds = 8;

struct Contribution {
    int particle;
    double kernel;
};

// Particles sorted into cubes, for range searches.
class ParticleGrid {
  public:
    ParticleGrid(const Discretisation& solid, double cell) : cell_(cell) {
        for (int i = 0; i < static_cast<int>(solid.particles.size()); ++i)
            sorted_.push_back({key(solid.particles[i].position), i});
        std::sort(sorted_.begin(), sorted_.end());
    }

    // Cube by cube, in each in the order of their numbers. The three of a column follow each other.
    template <class Visit>
    void forEachNear(const Vec3& x, Visit visit) const {
        const Key centre = key(x);
        for (int dx = -1; dx <= 1; ++dx)
            for (int dy = -1; dy <= 1; ++dy) {
                const Key low = {centre[0] + dx, centre[1] + dy, centre[2] - 1};
                const Key high = {low[0], low[1], centre[2] + 1};
                auto entry = std::lower_bound(sorted_.begin(), sorted_.end(), std::make_pair(low, -1));
                for (; entry != sorted_.end() && entry->first <= high; ++entry) visit(entry->second);
            }
    }

  private:
    using Key = std::array<long, 3>;

    Key key(const Vec3& x) const {
        const Vec3 k = (x / cell_).array().floor();
        return {static_cast<long>(k.x()), static_cast<long>(k.y()), static_cast<long>(k.z())};
    }

    double cell_;
    std::vector<std::pair<Key, int>> sorted_;
};

// Those at each particle, one after the other.
struct Contributions {
    std::vector<std::size_t> first = {0};  // #particles + 1
    std::vector<Contribution> all;
};

Contributions contributionsAtParticles(const Discretisation& solid) {
    double largest_radius = 0;
    for (const Particle& p : solid.particles) largest_radius = std::max(largest_radius, kernelRadius(p));
    const ParticleGrid grid(solid, largest_radius);
    Contributions result;
    for (const Particle& own : solid.particles) {
        grid.forEachNear(own.position, [&](int j) {
            const Particle& p = solid.particles[j];
            const double squared = (p.position - own.position).squaredNorm(), radius = kernelRadius(p);
            if (squared >= radius * radius) return;
            const double r = std::sqrt(squared) / radius;
            if (r < 1) result.all.push_back({j, kernel(r * r)});
        });
        result.first.push_back(result.all.size());
    }
    return result;
}

// Sums by label, of which there are few at one place.
class LabelSums {
  public:
    void clear() { sums_.clear(); }
    void add(int label, double value) {
        for (auto& [known, sum] : sums_)
            if (known == label) {
                sum += value;
                return;
            }
        sums_.emplace_back(label, value);
    }
    /// The sum of a label over the largest of the others.
    double ownOverNext(int own) const {
        double at_own = 0, next = 0;
        for (const auto& [label, sum] : sums_)
            if (label == own)
                at_own = sum;
            else
                next = std::max(next, sum);
        return next > 0 ? at_own / next : std::numeric_limits<double>::infinity();
    }

  private:
    std::vector<std::pair<int, double>> sums_;
};

// The density of a particle's own label at its position over that of the next one.
double ownOverNext(const Contributions& near, int particle, const std::vector<double>& weights,
                   const FragmentLabels& labels, LabelSums& sums) {
    sums.clear();
    for (std::size_t k = near.first[particle]; k < near.first[particle + 1]; ++k) {
        const Contribution& c = near.all[k];
        const RunnerUp runner_up = labels.runnerUpOf(c.particle);
        const double value = weights[c.particle] * c.kernel;
        sums.add(labels.of_particle[c.particle], (1 - runner_up.share) * value);
        if (runner_up.share > 0) sums.add(runner_up.label, runner_up.share * value);
    }
    return sums.ownOverNext(labels.of_particle[particle]);
}

}  // namespace

std::vector<double> particleWeights(const Discretisation& solid, const FragmentLabels& labels) {
    const int count = static_cast<int>(solid.particles.size());
    std::vector<double> fill(count), weights;
    for (int i = 0; i < count; ++i)
        fill[i] = solid.particles[i].volume / std::pow(kernelRadius(solid.particles[i]), 3);
    weights = fill;
    const Contributions near = contributionsAtParticles(solid);
    LabelSums sums;
    std::vector<int> contested(count);  // those with another label in reach, which the weights do not change
    std::iota(contested.begin(), contested.end(), 0);
    for (int round = 0; round < raising_rounds; ++round) {
        bool raised = false;
        std::size_t kept = 0;
        for (const int i : contested) {
            const double ratio = ownOverNext(near, i, weights, labels, sums);
            if (std::isinf(ratio)) continue;
            contested[kept++] = i;
            // Right beside a crack a particle has no more than its own share of what is there.
            const double share = labels.runnerUpOf(i).share;
            const double wanted = share > 0 ? std::min(winning_ratio, (1 - share) / share) : winning_ratio;
            if (ratio >= wanted || weights[i] >= largest_raise * fill[i]) continue;
            const double raise = ratio > 0 ? std::min(most_at_once, wanted / ratio * 1.1) : most_at_once;
            weights[i] = std::min(largest_raise * fill[i], raise * weights[i]);
            raised = true;
        }
        contested.resize(kept);
        if (!raised) break;
    }
    return weights;
}

}  // namespace sherd
