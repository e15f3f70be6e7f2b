#include "geometry/cutting/exact_orientation.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace sherd {

int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
    const auto point = [](const Vec3& p) { return Point(p.x(), p.y(), p.z()); };
    return static_cast<int>(CGAL::orientation(point(a), point(b), point(c), point(d)));
}

}  // namespace sherd
