#include "geometry/cutting/particle_weights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

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
            buckets_[key(solid.particles[i].position)].push_back(i);
    }

    template <class Visit>
    void forEachNear(const Vec3& x, Visit visit) const {
        const auto centre = key(x);
        for (int dx = -1; dx <= 1; ++dx)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dz = -1; dz <= 1; ++dz) {
                    const auto bucket = buckets_.find({centre[0] + dx, centre[1] + dy, centre[2] + dz});
                    if (bucket == buckets_.end()) continue;
                    for (int i : bucket->second) visit(i);
                }
    }

  private:
    std::array<long, 3> key(const Vec3& x) const {
        const Vec3 k = (x / cell_).array().floor();
        return {static_cast<long>(k.x()), static_cast<long>(k.y()), static_cast<long>(k.z())};
    }

    double cell_;
    std::map<std::array<long, 3>, std::vector<int>> buckets_;
};

std::vector<std::vector<Contribution>> contributionsAtParticles(const Discretisation& solid) {
    double largest_radius = 0;
    for (const Particle& p : solid.particles) largest_radius = std::max(largest_radius, kernelRadius(p));
    const ParticleGrid grid(solid, largest_radius);
    std::vector<std::vector<Contribution>> result(solid.particles.size());
    for (std::size_t i = 0; i < result.size(); ++i)
        grid.forEachNear(solid.particles[i].position, [&](int j) {
            const Particle& p = solid.particles[j];
            const double r = (p.position - solid.particles[i].position).norm() / kernelRadius(p);
            if (r < 1) result[i].push_back({j, kernel(r * r)});
        });
    return result;
}

// The density of a particle's own label at its position over that of the next one.
double ownOverNext(const std::vector<Contribution>& near, const std::vector<double>& weights,
                   const FragmentLabels& labels, int own) {
    std::map<int, double> sums;
    for (const Contribution& c : near) {
        const RunnerUp runner_up = labels.runnerUpOf(c.particle);
        const double value = weights[c.particle] * c.kernel;
        sums[labels.of_particle[c.particle]] += (1 - runner_up.share) * value;
        if (runner_up.share > 0) sums[runner_up.label] += runner_up.share * value;
    }
    double next = 0;
    for (const auto& [label, sum] : sums)
        if (label != own) next = std::max(next, sum);
    return next > 0 ? sums[own] / next : std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<double> particleWeights(const Discretisation& solid, const FragmentLabels& labels) {
    const int count = static_cast<int>(solid.particles.size());
    std::vector<double> fill(count), weights;
    for (int i = 0; i < count; ++i)
        fill[i] = solid.particles[i].volume / std::pow(kernelRadius(solid.particles[i]), 3);
    weights = fill;
    const auto near = contributionsAtParticles(solid);
    for (int round = 0; round < raising_rounds; ++round) {
        bool raised = false;
        for (int i = 0; i < count; ++i) {
            const double ratio = ownOverNext(near[i], weights, labels, labels.of_particle[i]);
            // Right beside a crack a particle has no more than its own share of what is there.
            const double share = labels.runnerUpOf(i).share;
            const double wanted = share > 0 ? std::min(winning_ratio, (1 - share) / share) : winning_ratio;
            if (ratio >= wanted || weights[i] >= largest_raise * fill[i]) continue;
            const double raise = ratio > 0 ? std::min(most_at_once, wanted / ratio * 1.1) : most_at_once;
            weights[i] = std::min(largest_raise * fill[i], raise * weights[i]);
            raised = true;
        }
        if (!raised) break;
    }
    return weights;
}

}  // namespace sherd
