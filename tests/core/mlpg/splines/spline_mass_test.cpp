#include "core/mlpg/splines/spline_mass.h"

#include "core/mlpg/splines/spline_inertia.h"
#include "core/mlpg/splines/spline_motions.h"
#include "core/mlpg/splines/spline_support.h"

namespace sherd {
namespace {

// The energy of a rigid motion is that of the rigid body, whatever its cells look like.
TEST(SplineMass, OfRigidMotionsIsThatOfTheBody) {
    for (const int degree : {2, 3}) {
        const CellParts solid = partsOf(tiltedBox(), 0.11, degree);
        const SplineSpace space(solid, degree);
        const RigidMotions motions = splineMotions(solid, space);
        const SparseMatrix mass = splineMass(solid, space);
        const Eigen::MatrixXd found =
            motions.coefficients.transpose() * massProduct(mass, motions.coefficients);
        const auto expected = splineInertia(inertiaMoments(solid, space, motions), motions).mass(0);
        EXPECT_LT((found - expected).norm(), 1e-9 * expected.norm());
        EXPECT_NEAR(found(0, 0), 0.24, 1e-9);
    }
}

}  // namespace
}  // namespace sherd
