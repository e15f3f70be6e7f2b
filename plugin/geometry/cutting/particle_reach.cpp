#include "geometry/cutting/particle_reach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace sherd {

namespace {

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

}  // namespace

ParticleReach reachOfParticles(const Discretisation& solid) {
    double largest_radius = 0;
    for (const Particle& p : solid.particles) largest_radius = std::max(largest_radius, kernelRadius(p));
    const ParticleGrid grid(solid, largest_radius);
    ParticleReach result;
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

}  // namespace sherd
