#include "core/sampling/nearest_owner.h"

#include <algorithm>
#include <limits>

namespace sherd {

int nearestOwner(const Discretisation& solid, const Vec3& x) {
    // In spacings: the particle that owns the nearest cell is at most so much farther away than the nearest
    // particle.
    constexpr double margin = 2;
    double nearest_particle = std::numeric_limits<double>::infinity();
    for (const Particle& particle : solid.particles)
        nearest_particle = std::min(nearest_particle, (particle.position - x).norm());

    int owner = 0;
    double nearest_cell = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < solid.particles.size(); ++i) {
        const Particle& particle = solid.particles[i];
        if ((particle.position - x).norm() > nearest_particle + margin * particle.spacing) continue;
        for (int cell : solid.particle_cells[i]) {
            const double distance = (solid.cells[cell].moments.centroid - x).squaredNorm();
            if (distance >= nearest_cell) continue;
            nearest_cell = distance;
            owner = static_cast<int>(i);
        }
    }
    return owner;
}

}  // namespace sherd
