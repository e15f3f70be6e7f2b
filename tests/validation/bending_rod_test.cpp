#include "validation/bending_rod.h"

namespace sherd::validation::bending_rod {
namespace {

TEST(BendingRod, SplinesAreAccurateWithOneParticleAcrossAtAnyTilt) {
    for (double angle : {0.0, 0.2, 0.5, 0.8}) {
        const Mat3 tilt = (Eigen::AngleAxisd(angle, Vec3(1, 2, 3).normalized())).toRotationMatrix();
        EXPECT_LT(bendingError(splines(Basis::quadratic), side, tilt), 0.06) << "tilt " << angle;
        EXPECT_LT(bendingError(splines(Basis::quadratic), side / 2, tilt), 0.03) << "tilt " << angle;
    }
}

}  // namespace
}  // namespace sherd::validation::bending_rod
