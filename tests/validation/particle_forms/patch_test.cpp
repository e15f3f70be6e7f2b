#include "validation/patch.h"

namespace sherd::validation {
namespace {

void expectPatch(const StressSettings& settings, double spacing) {
    const Material material = elasticMaterial();
    const Mat3 stress = Elasticity(material).stress(patch_gradient);
    for (const TriangleMesh& mesh : cutSolids()) {
        const auto solid = sampled(mesh, spacing);
        jitter(*solid, 0.15);
        const StressSolver solver = build(solid, material, settings);
        const StressField field = valueOf(
            solver.solveTraction([&](const Vec3&, const Vec3& normal) { return Vec3(stress * normal); }));
        EXPECT_LT(largestError(field.particles, stress), 1e-8);
        EXPECT_LT(largestError(field.surface, stress), 1e-8);
        EXPECT_LT(field.residual_rel, 1e-10);
    }
}

TEST(Patch, GalerkinGmls) {
    expectPatch(galerkin_gmls, 0.12);
}
TEST(Patch, GalerkinMls) {
    expectPatch(galerkin_mls, 0.1);
}
TEST(Patch, GalerkinQuadraticMls) {
    expectPatch(form(TestFunction::galerkin, TrialFunction::mls, Basis::quadratic), 0.1);
}

// On a linear field even the flux form is exact: one point a face integrates a constant stress.
TEST(Patch, HeavisideMls) {
    expectPatch(heaviside_mls, 0.1);
}

StressField constantStress(const StressSettings& settings, double jitter_amplitude) {
    const Material material = elasticMaterial();
    const auto solid = sampled(shapes::slab({1, 0.6, 0.4}), 0.1);
    jitter(*solid, jitter_amplitude);
    const Mat3 stress = Elasticity(material).stress(patch_gradient);
    return valueOf(build(solid, material, settings).solveTraction([&](const Vec3&, const Vec3& normal) {
        return Vec3(stress * normal);
    }));
}

// The paper's cubes fill a box that is aligned with its grid, and only such a solid.
TEST(Patch, HeavisidePaperOnAlignedBox) {
    const Mat3 stress = Elasticity(elasticMaterial()).stress(patch_gradient);
    for (const double amplitude : {0.0, 0.15}) {
        const StressField field = constantStress(heaviside_paper, amplitude);
        EXPECT_LT(largestError(field.particles, stress), 1e-8);
        EXPECT_LT(largestError(field.surface, stress), 1e-8);
        EXPECT_LT(field.residual_rel, 1e-10);

        const StressField tiled = constantStress(heaviside_mls, amplitude);
        ASSERT_EQ(field.particles.size(), tiled.particles.size());
        for (size_t i = 0; i < field.particles.size(); ++i)
            EXPECT_LT((field.particles[i] - tiled.particles[i]).norm(), 1e-8 * stress.norm());
    }
}

// The displacement field need not come from a solve: sampled at the particles, a linear one has the exact
// stress.
TEST(Patch, StressOfALinearField) {
    const Material material = elasticMaterial();
    const Mat3 stress = Elasticity(material).stress(patch_gradient);
    for (const StressSettings& settings : {galerkin_gmls, galerkin_mls, heaviside_mls}) {
        const auto solid = sampled(shapes::icosphere(0.5, 3), 0.12);
        jitter(*solid, 0.15);
        const StressField field =
            build(solid, material, settings)
                .stressOf([](const Vec3& x) { return Vec3(patch_gradient * x + Vec3(1, 2, 3)); },
                          [](const Vec3&) { return patch_gradient; });
        EXPECT_LT(largestError(field.particles, stress), 1e-8);
        EXPECT_LT(largestError(field.surface, stress), 1e-8);
    }
}

TEST(Patch, RigidMotionMakesNoStress) {
    const Mat3 rotation = (Mat3() << 0, 1, 2, -1, 0, 3, -2, -3, 0).finished();
    const Material material = elasticMaterial();
    for (const StressSettings& settings : {galerkin_gmls, galerkin_mls, heaviside_mls})
        for (const TriangleMesh& mesh : cutSolids()) {
            const StressField field =
                build(sampled(mesh, 0.12), material, settings)
                    .stressOf([&](const Vec3& x) { return Vec3(rotation * x + Vec3(5, -7, 9)); },
                              [&](const Vec3&) { return rotation; });
            for (const std::vector<SymmetricTensor>* stresses : {&field.particles, &field.surface})
                for (const SymmetricTensor& stress : *stresses)
                    ASSERT_LT(stress.norm(), 1e-9 * material.youngs_modulus_pa * rotation.norm());
        }
}

}  // namespace
}  // namespace sherd::validation
