#include "core/mlpg/particle_forms/particle_motions.h"

namespace sherd {
namespace {

std::vector<Moments> componentMoments(const Discretisation& solid, const Components& components) {
    std::vector<Moments> moments(components.count);
    for (const IntegrationCell& cell : solid.cells) {
        Moments& sum = moments[components.of_particle[cell.particle]];
        sum.volume += cell.moments.volume;
        sum.centroid += cell.moments.volume * cell.moments.centroid;
    }
    for (Moments& sum : moments) sum.centroid /= sum.volume;
    for (const IntegrationCell& cell : solid.cells) {
        Moments& sum = moments[components.of_particle[cell.particle]];
        const Vec3 offset = cell.moments.centroid - sum.centroid;
        sum.second += cell.moments.second + cell.moments.volume * offset * offset.transpose();
    }
    return moments;
}

}  // namespace

RigidMotions particleMotions(const Discretisation& solid, const TrialSpace& space) {
    const Components components = connectedComponents(solid);
    const int block = space.unknownsPerParticle();
    RigidMotions motions(components.of_particle, componentMoments(solid, components), block);
    for (size_t i = 0; i < solid.particles.size(); ++i) {
        const int component = components.of_particle[i];
        const Particle& particle = solid.particles[i];
        const long row = static_cast<long>(i) * block;
        motions.coefficients.middleRows<3>(row) = motions.at(particle.position, component);
        if (block == 3) continue;
        // h d(e_k x r)/dx_j = h e_k x e_j
        for (int j = 0; j < 3; ++j)
            motions.coefficients.block<3, 3>(row + 3 + 3 * j, 3) =
                -crossMatrix(Vec3::Unit(j)) * particle.spacing / motions.size[component];
    }
    return motions;
}

}  // namespace sherd
