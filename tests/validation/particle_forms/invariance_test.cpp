#include "validation/invariance.h"

namespace sherd::validation::invariance {
namespace {

/// The same solid with its particles numbered backwards.
Discretisation reversed(Discretisation solid) {
    const int last = static_cast<int>(solid.particles.size()) - 1;
    std::reverse(solid.particles.begin(), solid.particles.end());
    std::reverse(solid.neighbours.begin(), solid.neighbours.end());
    std::reverse(solid.particle_cells.begin(), solid.particle_cells.end());
    for (auto& list : solid.neighbours) {
        for (int& particle : list) particle = last - particle;
        std::reverse(list.begin(), list.end());
    }
    for (IntegrationCell& cell : solid.cells) cell.particle = last - cell.particle;
    return solid;
}

/// The same solid carried to another place and orientation, particles and cells with it.
Discretisation carried(Discretisation solid, const Mat3& rotation, const Vec3& offset) {
    for (Particle& particle : solid.particles) particle.position = rotation * particle.position + offset;
    for (IntegrationCell& cell : solid.cells) {
        cell.moments.centroid = rotation * cell.moments.centroid + offset;
        cell.moments.second = rotation * cell.moments.second * rotation.transpose();
    }
    for (IntegrationFace& face : solid.faces) {
        face.area = rotation * face.area;
        face.centroid = rotation * face.centroid + offset;
    }
    for (SurfacePoint& point : solid.surface_points) {
        point.area = rotation * point.area;
        point.position = rotation * point.position + offset;
    }
    return solid;
}

TEST(Invariance, ParticleOrderAndRigidMotion) {
    const auto solid = sampled(shapes::slab(size), 0.1);
    const std::vector<PointForce> loads = {{{0.22, 0.11, 0.1}, {10, 0, -100}},
                                           {{-0.13, 0.02, 0.1}, {0, 5, -50}}};
    const Mat3 rotation = someRotation();
    const Vec3 offset(3, -5, 7);
    std::vector<PointForce> carried_loads = loads;
    for (PointForce& load : carried_loads) load = {rotation * load.position + offset, rotation * load.force};

    for (const StressSettings& settings : {galerkin_gmls, galerkin_mls, heaviside_mls}) {
        const StressField field = valueOf(build(solid, elasticMaterial(), settings).solve(loads));
        StressField other =
            valueOf(build(std::make_shared<Discretisation>(reversed(*solid)), elasticMaterial(), settings)
                        .solve(loads));
        std::reverse(other.particles.begin(), other.particles.end());
        EXPECT_LT(largestDifference(field.particles, other.particles, 1), 1e-8);

        other = valueOf(build(std::make_shared<Discretisation>(carried(*solid, rotation, offset)),
                              elasticMaterial(), settings)
                            .solve(carried_loads));
        for (SymmetricTensor& stress : other.particles)
            stress = toSymmetricTensor(rotation.transpose() * toMatrix(stress) * rotation);
        EXPECT_LT(largestDifference(field.particles, other.particles, 1), 1e-8);
    }
}

}  // namespace
}  // namespace sherd::validation::invariance
