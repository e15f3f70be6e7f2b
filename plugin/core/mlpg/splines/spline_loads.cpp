#include "core/mlpg/splines/spline_loads.h"

#include "core/mlpg/splines/b_spline.h"
#include "core/mlpg/splines/body_moments.h"

namespace sherd {

bool addPointForces(const CellParts& solid, const SplineSpace& space, const std::vector<PointForce>& loads,
                    Eigen::Matrix3Xd& raw) {
    std::vector<double> values;
    for (const PointForce& load : loads) {
        const GridPoint point = locate(solid, load.position);
        if (point.part < 0) return false;
        splineValues(space.degree, point.xi, values);
        const std::vector<int>& functions = space.raw_of[point.part];
        for (size_t a = 0; a < functions.size(); ++a) raw.col(functions[a]) += values[a] * load.force;
    }
    return true;
}

Eigen::Matrix3Xd bodyForcesAt(const CellParts& solid, const SplineSpace& space,
                              const std::vector<AffineForce>& body_forces) {
    Eigen::Matrix3Xd raw = Eigen::Matrix3Xd::Zero(3, space.raw_count);
    std::vector<Vec3> origins;
    for (const AffineForce& force : body_forces) origins.push_back(force.about);
    const Eigen::Matrix4Xd body = splineBodyMoments(solid, space, origins);
    for (size_t p = 0; p < solid.parts.size(); ++p)
        for (const int f : space.raw_of[p])  // all parts of a function are of one body, under one force
            raw.col(f) = body_forces[p].value * body(0, f) + body_forces[p].gradient * body.col(f).tail<3>();
    return raw;
}

BodyLoads loadsInside(const CellParts& fine, const SplineSpace& fine_space, const std::vector<int>& parents,
                      const BodyLoads& coarse) {
    BodyLoads inside;
    for (const PointForce& load : coarse.forces)
        if (fine.partAt(load.position) >= 0) inside.forces.push_back(load);
    std::vector<AffineForce> of_component(fine_space.component_count);
    for (size_t part = 0; part < parents.size(); ++part)
        if (parents[part] >= 0)
            of_component[fine_space.component_of_part[part]] = coarse.body_forces[parents[part]];
    for (const int component : fine_space.component_of_part)
        inside.body_forces.push_back(of_component[component]);
    return inside;
}

}  // namespace sherd
