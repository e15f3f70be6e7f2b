#include "validation/patch.h"

namespace sherd::validation {
namespace {

TEST(Patch, Splines) {
    const Material material = elasticMaterial();
    const Mat3 stress = Elasticity(material).stress(patch_gradient);
    for (const Basis basis : all_bases)
        for (const TriangleMesh& mesh : cutSolids()) {
            const ClosedForm constant{mesh, material, [&](const Vec3&) { return stress; }};
            const auto solid = sampledForSplines(mesh, 0.12, basis);
            const StressField field =
                valueOf(build(solid, material, splines(basis)).solve(tractions(constant, *solid)));
            // Cubics that are continued over slivers have a condition that costs a digit more.
            const double rounding = basis == Basis::cubic ? 1e-6 : 1e-8;
            EXPECT_LT(largestError(field.particles, stress), rounding);
            EXPECT_LT(largestError(field.surface, stress), rounding);
            EXPECT_LT(field.residual_rel, 1e-10);
            EXPECT_LT(field.imbalance_rel, 1e-10);
        }
}

}  // namespace
}  // namespace sherd::validation
