#include "core/mlpg/splines/spline_space.h"

namespace sherd {
namespace {

/// Numbers the connected components of the parts; returns how many there are.
int findComponents(const CellParts& solid, std::vector<int>& component_of_part) {
    const int part_count = static_cast<int>(solid.parts.size());
    int count = 0;
    component_of_part.assign(part_count, -1);
    std::vector<int> queue;
    for (int first = 0; first < part_count; ++first) {
        if (component_of_part[first] >= 0) continue;
        queue.assign(1, first);
        component_of_part[first] = count;
        for (size_t next = 0; next < queue.size(); ++next)
            for (const int other : solid.neighbours[queue[next]]) {
                if (component_of_part[other] >= 0) continue;
                component_of_part[other] = count;
                queue.push_back(other);
            }
        ++count;
    }
    return count;
}

}  // namespace

SplineSpace::SplineSpace(const CellParts& solid, int spline_degree)
    : SplineSpace(solid, RawFunctions(solid, spline_degree)) {}

SplineSpace::SplineSpace(const CellParts& solid, RawFunctions raw)
    : degree(raw.degree), raw_count(raw.count()), ties_(solid, raw) {
    component_count = findComponents(solid, component_of_part);
    function_count = static_cast<int>(ties_.raw_of_function.size());
    for (const int function : ties_.raw_of_function) {
        highest_cells.push_back(raw.highest_cells[function]);
        component.push_back(component_of_part[raw.supports[function][0]]);
    }
    findGrevillePoints(solid);
    raw_of = std::move(raw.of_part);
}

void SplineSpace::findGrevillePoints(const CellParts& solid) {
    const Vec3 to_greville_point = Vec3::Constant((1 - degree) / 2.0);
    greville_points.clear();
    for (const Eigen::Vector3i& highest : highest_cells)
        greville_points.push_back(solid.origin +
                                  (highest.cast<double>() + to_greville_point).cwiseProduct(solid.edges));
}

Eigen::Matrix3Xd SplineSpace::expand(const Eigen::VectorXd& unknowns) const {
    Eigen::Matrix3Xd raw = Eigen::Matrix3Xd::Zero(3, raw_count);
    for (int r = 0; r < raw_count; ++r)
        for (const SplineTies::Term& term : termsOf(r))
            raw.col(r) += term.factor * unknowns.segment<3>(3L * term.function);
    return raw;
}

Eigen::VectorXd SplineSpace::gather(const Eigen::Matrix3Xd& raw) const {
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(3L * function_count);
    for (int r = 0; r < raw_count; ++r)
        for (const SplineTies::Term& term : termsOf(r))
            forces.segment<3>(3L * term.function) += term.factor * raw.col(r);
    return forces;
}

}  // namespace sherd
