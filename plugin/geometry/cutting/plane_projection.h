#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <sherd/types.h>

namespace sherd {

using PlaneKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// Drops the coordinate along which the normal is longest; keeps the orientation.
inline PlaneKernel::Point_2 project(const Vec3& x, const Vec3& normal) {
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    const double u = x[(axis + 1) % 3], v = x[(axis + 2) % 3];
    return normal[axis] > 0 ? PlaneKernel::Point_2(u, v) : PlaneKernel::Point_2(v, u);
}

}  // namespace sherd
