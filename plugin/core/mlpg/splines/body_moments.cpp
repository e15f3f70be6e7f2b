#include "core/mlpg/splines/body_moments.h"

#include "core/mlpg/splines/part_integrals.h"

namespace sherd {

Eigen::Matrix4Xd splineBodyMoments(const CellParts& solid, const SplineSpace& space,
                                   const std::vector<Vec3>& origins) {
    const PartIntegrals integrals(space.degree, solid.edges);
    Eigen::Matrix4Xd raw = Eigen::Matrix4Xd::Zero(4, space.raw_count);
    for (size_t p = 0; p < solid.parts.size(); ++p) {
        const CellPart& part = solid.parts[p];
        const Vec3 middle =
            solid.origin + (part.cell.cast<double>() + Vec3::Constant(0.5)).cwiseProduct(solid.edges);
        const Eigen::Matrix4Xd own = integrals.bodyMoments(part, middle - origins[p]);
        for (int a = 0; a < space.perPart(); ++a) raw.col(space.raw_of[p][a]) += own.col(a);
    }
    return raw;
}

}  // namespace sherd
