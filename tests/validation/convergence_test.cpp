#include "validation/known_fields.h"

namespace sherd::validation {
namespace {

void expectRates(const ClosedForm& form, const std::array<double, 3>& spacings, Basis basis) {
    const Convergence found = converge(form, spacings, basis);
    EXPECT_GT(found.interior_rate, expectedRate(basis));
    EXPECT_GT(found.surface_rate, expectedRate(basis));
}

TEST(Convergence, ThickCylinder) {
    for (const Basis basis : all_bases) expectRates(thickCylinder(), {0.05, 0.035, 0.025}, basis);
}

TEST(Convergence, HollowSphere) {
    expectRates(hollowSphere(), {0.25, 0.18, 0.125}, Basis::quadratic);
}

TEST(Convergence, Cantilever) {
    for (const Basis basis : {Basis::linear, Basis::quadratic})
        expectRates(turned(cantilever(), someRotation()), {0.125, 0.09, 0.0625}, basis);
}

// Its displacement is cubic, so cubic splines say it exactly, in cut cells as in whole ones; what is left is
// rounding times the condition of functions that were continued over slivers.
TEST(Convergence, CubicSplinesHoldTheCantileverToRounding) {
    EXPECT_LT(errorsOf(turned(cantilever(), someRotation()), 0.1, Basis::cubic).interior, 1e-6);
}

TEST(Convergence, FreeRodAtAnyTilt) {
    for (const double angle : {0.0, 0.2, 0.5, 0.8}) {
        const Mat3 tilt = Eigen::AngleAxisd(angle, Vec3(1, 2, 3).normalized()).toRotationMatrix();
        expectRates(turned(wavyRod(), tilt), {0.075, 0.05, 0.0333}, Basis::quadratic);
    }
}

TEST(Convergence, PlateInBending) {
    for (const Basis basis : {Basis::quadratic, Basis::cubic})
        expectRates(turned(bentPlate(), someRotation()), {0.12, 0.085, 0.06}, basis);
}

// Strains within the surface converge better than the stress across it, which the traction replaces.
TEST(Convergence, TractionsMendTheStressAtTheSurface) {
    for (const ClosedForm& form : {thickCylinder(), turned(bentPlate(), someRotation())}) {
        const double spacing = form.surface.vertices[0].norm() < 0.3 ? 0.035 : 0.085;
        const Errors errors = errorsOf(form, spacing, Basis::quadratic);
        EXPECT_LT(errors.with_traction, 0.6 * errors.surface);
    }
}

}  // namespace
}  // namespace sherd::validation
