#include "core/mlpg/point_loads.h"

#include <limits>

namespace sherd {

int LoadPlacement::ownerAt(const Vec3& x) const {
    constexpr double farthest = 2;  // in particle spacings
    double nearest_particle = std::numeric_limits<double>::infinity();
    for (const Particle& particle : solid_->particles)
        nearest_particle = std::min(nearest_particle, (particle.position - x).norm());

    // The nearest cell belongs to the nearest particle or to one not much farther.
    int owner = -1;
    double nearest_cell = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < solid_->particles.size(); ++i) {
        const Particle& particle = solid_->particles[i];
        if ((particle.position - x).norm() > nearest_particle + farthest * particle.spacing) continue;
        for (int cell : solid_->particle_cells[i]) {
            const double distance = (solid_->cells[cell].moments.centroid - x).norm();
            if (distance >= nearest_cell) continue;
            nearest_cell = distance;
            owner = static_cast<int>(i);
        }
    }
    if (owner < 0 || !(nearest_cell <= farthest * solid_->particles[owner].spacing)) return -1;
    return owner;
}

}  // namespace sherd
