#include "stress_model/surface_tractions.h"

#include <algorithm>

#include "core/stress/surface_traction.h"

namespace sherd {

SurfaceTractions::SurfaceTractions(const BreakableSolid& body, const std::vector<PlacedLoad>& loads)
    : solid_(body), elasticity_(body.material()), loads_(loads) {
    for (const PlacedLoad& placed : loads) load_regions_.emplace_back(body.surface(), placed.load.region);
    for (const SurfaceRegion& support : body.supports())
        support_regions_.emplace_back(body.surface(), support);
}

SymmetricTensor SurfaceTractions::imposedOn(const SymmetricTensor& raw, const SurfaceFoot& foot) const {
    const auto isOn = [&](const RegionOnSurface& region) {
        return region.holds(foot.triangle, foot.position);
    };
    if (foot.normal.isZero() || std::any_of(support_regions_.begin(), support_regions_.end(), isOn))
        return raw;
    Vec3 traction = Vec3::Zero();
    for (std::size_t i = 0; i < loads_.size(); ++i) {
        const SurfaceLoad& load = loads_[i].load;
        if (isOn(load_regions_[i]))
            traction += load.force_n / loads_[i].area_m2 - load.pressure_pa * foot.normal;
    }
    return withTraction(raw, foot.normal, traction, elasticity_);
}

void SurfaceTractions::imposeOnSurface(std::vector<SymmetricTensor>& surface) const {
    const Discretisation& solid = *solid_.discretisation().value();
    // Most points lie far from all that acts; only the others need to know their triangle.
    std::vector<std::size_t> near;
    std::vector<Vec3> positions;
    for (std::size_t q = 0; q < surface.size(); ++q) {
        const SurfacePoint& point = solid.surface_points[q];
        if (point.normal.isZero()) continue;
        const auto mayHold = [&](const RegionOnSurface& region) {
            return region.mayHold(point.position, solid.spacing);
        };
        if (std::any_of(load_regions_.begin(), load_regions_.end(), mayHold) ||
            std::any_of(support_regions_.begin(), support_regions_.end(), mayHold)) {
            near.push_back(q);
            positions.push_back(point.position);
        } else {
            surface[q] = withTraction(surface[q], point.normal, Vec3::Zero(), elasticity_);
        }
    }
    std::vector<SurfaceFoot> feet = surfaceFeet(solid_.surface(), positions, edgeTolerance(solid_));
    for (std::size_t i = 0; i < near.size(); ++i) {
        feet[i].normal = solid.surface_points[near[i]].normal;
        surface[near[i]] = imposedOn(surface[near[i]], feet[i]);
    }
}

double edgeTolerance(const BreakableSolid& body) {
    constexpr double of_wall = 0.005;
    return of_wall * body.wallThickness();
}

}  // namespace sherd
