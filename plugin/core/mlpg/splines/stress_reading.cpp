#include "core/mlpg/splines/stress_reading.h"

#include "core/stress/loaded_places.h"
#include "core/stress/surface_traction.h"

namespace sherd {

std::vector<GridPoint> locateSamples(const Discretisation& solid) {
    std::vector<GridPoint> samples;
    samples.reserve(solid.particles.size() + solid.surface_points.size());
    for (const Particle& particle : solid.particles)
        samples.push_back(locate(solid.parts, particle.position));
    for (const SurfacePoint& point : solid.surface_points)
        samples.push_back(locate(solid.parts, point.position));
    return samples;
}

void readStress(const SplineProblem& problem, const std::vector<GridPoint>& samples, const SplineField& whole,
                const std::vector<Zoom>& zooms, const std::vector<Vec3>& points, StressField& field) {
    double spacing = 0;  // of the grid that was read last
    const auto stress_at = [&](const Vec3& x, const GridPoint& on_whole) -> SymmetricTensor {
        Mat3 gradient;
        for (size_t z = zooms.size(); z-- > 0;)
            if (displacementGradient(zooms[z], x, gradient)) {
                spacing = zooms[z].field.parts->edges.maxCoeff();
                return toSymmetricTensor(problem.elasticity.stress(gradient));
            }
        spacing = whole.parts->edges.maxCoeff();
        if (on_whole.part < 0) return SymmetricTensor::Zero();
        const SymmetricTensor stress =
            toSymmetricTensor(problem.elasticity.stress(gradientOn(whole, on_whole.part, on_whole.xi)));
        return problem.shares.empty() ? stress : SymmetricTensor(problem.shares[on_whole.part] * stress);
    };
    const Discretisation& solid = *problem.solid;
    field.particles.reserve(solid.particles.size());
    field.surface.reserve(solid.surface_points.size());
    size_t sample = 0;
    for (const Particle& particle : solid.particles)
        field.particles.push_back(stress_at(particle.position, samples[sample++]));
    for (const SurfacePoint& point : solid.surface_points)
        field.surface.push_back(stress_at(point.position, samples[sample++]));
    for (const Vec3& point : points) {
        field.points.push_back(stress_at(point, locate(*whole.parts, point)));
        field.point_spacing_m.push_back(spacing);
    }
}

void addNearField(const Discretisation& solid, const ContactField& contact, const Elasticity& elasticity,
                  StressField& field) {
    const LoadedPlaces loaded(contact.others, solid.spacing);
    const auto add = [&](const Vec3& x, const Vec3& normal, SymmetricTensor& stress) {
        stress += toSymmetricTensor(contact.near.stressAt(x));
        if (!normal.isZero() && !loaded.isNear(x))
            stress = withTraction(stress, normal, contact.near.tractionAt(x, normal), elasticity);
    };
    for (size_t i = 0; i < field.particles.size(); ++i)
        add(solid.particles[i].position, Vec3::Zero(), field.particles[i]);
    for (size_t q = 0; q < field.surface.size(); ++q)
        add(solid.surface_points[q].position, solid.surface_points[q].normal, field.surface[q]);
    for (size_t i = 0; i < field.points.size(); ++i) {
        field.points[i] += contact.places[i].unresolved;
        add(contact.places[i].position, contact.places[i].normal, field.points[i]);
    }
}

}  // namespace sherd
