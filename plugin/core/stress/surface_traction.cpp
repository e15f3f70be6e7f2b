#include "core/stress/surface_traction.h"

#include "core/stress/loaded_places.h"

namespace sherd {

SymmetricTensor withTraction(const SymmetricTensor& raw, const Vec3& normal, const Vec3& traction_pa,
                             const Elasticity& elasticity) {
    const Mat3 within = Mat3::Identity() - normal * normal.transpose();
    const Mat3 stress = toMatrix(raw);
    const double along = traction_pa.dot(normal);
    const double coupling =
        elasticity.lambda_pa / (elasticity.lambda_pa + 2 * elasticity.mu_pa);  // nu / (1 - nu)
    const Vec3 tangential = traction_pa - along * normal;
    return toSymmetricTensor(within * stress * within +
                             coupling * (along - normal.dot(stress * normal)) * within +
                             tangential * normal.transpose() + normal * tangential.transpose() +
                             along * normal * normal.transpose());
}

void freeSurface(const Discretisation& solid, const std::vector<PointForce>& acting,
                 const Elasticity& elasticity, std::vector<SymmetricTensor>& surface) {
    const LoadedPlaces loaded(acting, solid.spacing);
    for (std::size_t q = 0; q < surface.size(); ++q) {
        const SurfacePoint& point = solid.surface_points[q];
        if (point.normal.isZero() || loaded.isNear(point.position)) continue;
        surface[q] = withTraction(surface[q], point.normal, Vec3::Zero(), elasticity);
    }
}

}  // namespace sherd
