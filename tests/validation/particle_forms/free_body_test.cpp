#include "validation/closed_form.h"

namespace sherd::validation {
namespace {

const std::vector<PointForce> oblique_blow = {{{0.5, 0.1, 0.05}, {-3, 1, 2}}, {{0.5, 0.15, 0}, {-2, 0, 1}}};

// Loads without any balance of their own: what is left after inertia relief, and of the solve, is rounding.
TEST(FreeBody, InertiaReliefLeavesNoResidual) {
    for (const StressSettings& settings : {galerkin_gmls, galerkin_mls, heaviside_mls}) {
        const auto solid = sampled(shapes::moved(shapes::slab({1, 0.6, 0.3}), someRotation()), 0.12);
        std::vector<PointForce> loads = oblique_blow;
        for (PointForce& load : loads) load = {someRotation() * load.position, load.force};
        const StressField field = valueOf(build(solid, elasticMaterial(), settings).solve(loads));
        EXPECT_LT(field.residual_rel, 1e-10);
        // Heaviside rows balance forces; the moment of a force is that about its particle.
        if (settings.test_function == TestFunction::galerkin) {
            EXPECT_LT(field.imbalance_rel, 1e-10);
        }
        EXPECT_GT(field.strain_energy_j, 0);
    }
}

// A rod pulled at one end accelerates as a whole: sigma_xx = F/A x/L, exactly, whatever the mass.
TEST(FreeBody, PulledRodCarriesItsOwnInertia) {
    const double length = 2, side = 0.2, force = 100;
    const auto solid = sampled(shapes::box({0, 0, 0}, {length, side, side}), 0.1);
    const auto loads =
        spreadOverSurface(*solid, {force, 0, 0}, [&](const Vec3&, const Vec3& n) { return n.x() > 0.9; });
    const StressField field = valueOf(build(solid, elasticMaterial(), galerkin_gmls).solve(loads));
    for (size_t i = 0; i < solid->particles.size(); ++i) {
        const double along = solid->particles[i].position.x() / length;
        if (along < 0.1 || along > 0.9) continue;
        EXPECT_NEAR(field.particles[i][0] / (force / (side * side)), along, 0.01);
    }
}

TEST(FreeBody, NoLoadNoStress) {
    const auto solid = sampled(shapes::slab({1, 1, 0.5}), 0.25);
    const StressField field = valueOf(build(solid, elasticMaterial(), galerkin_gmls).solve({}));
    for (const SymmetricTensor& stress : field.particles) EXPECT_EQ(stress.norm(), 0);
    EXPECT_EQ(field.strain_energy_j, 0);
}

// Two separate parts: each is balanced by itself, and the one that nothing touches is free of stress.
TEST(FreeBody, PartsAreBalancedOneByOne) {
    const TriangleMesh one = shapes::slab({1, 0.5, 0.3});
    const auto alone = sampledForSplines(one, 0.1, Basis::quadratic);
    const auto both =
        sampledForSplines(shapes::joined(one, shapes::translated(one, {0, 0, 0.6})), 0.1, Basis::quadratic);
    const auto loadsOn = [&](const Discretisation& solid) {
        return spreadOverSurface(solid, {0, 0, -50}, [](const Vec3& x, const Vec3& n) {
            return n.z() > 0.9 && x.z() < 0.2 && x.head<2>().norm() < 0.2;
        });
    };
    for (const StressSettings& settings : {galerkin_gmls, splines(Basis::quadratic)}) {
        const StressField single = valueOf(build(alone, elasticMaterial(), settings).solve(loadsOn(*alone)));
        const StressField pair = valueOf(build(both, elasticMaterial(), settings).solve(loadsOn(*both)));
        double peak = 0;
        for (const SymmetricTensor& stress : single.particles) peak = std::max(peak, stress.norm());
        for (size_t i = 0; i < both->particles.size(); ++i)
            if (both->particles[i].position.z() > 0.3) {
                EXPECT_LT(pair.particles[i].norm(), 1e-9 * peak);
            }
        EXPECT_NEAR(pair.strain_energy_j / single.strain_energy_j, 1, 1e-9);
    }
}

// A crumb of one particle: gmls carries its strain, mls has none to carry; neither may fail.
TEST(FreeBody, OneParticle) {
    const auto solid = sampled(shapes::slab({1, 1, 1}), 1.0);
    ASSERT_EQ(solid->particles.size(), 1u);
    const auto squeeze = [](const Vec3&, const Vec3& normal) {
        return Vec3(-1e6 * normal.z() * Vec3::UnitZ());
    };
    const StressField gmls = valueOf(build(solid, elasticMaterial(), galerkin_gmls).solveTraction(squeeze));
    EXPECT_NEAR(gmls.particles[0][2], -1e6, 1);
    EXPECT_TRUE(gmls.warnings.empty());
    const StressField mls = valueOf(build(solid, elasticMaterial(), galerkin_mls).solveTraction(squeeze));
    EXPECT_EQ(mls.particles[0].norm(), 0);
}

TEST(FreeBody, WrongInputGetsASentence) {
    const auto solid = sampled(shapes::slab({1, 1, 1}), 0.5);
    EXPECT_FALSE(StressSolver::build(nullptr, elasticMaterial(), galerkin_gmls).ok());
    for (const double nu : {0.5, 0.4995, -1.0})
        EXPECT_NE(StressSolver::build(solid, elasticMaterial(5e9, nu), galerkin_gmls)
                      .error()
                      .find("Poisson's ratio"),
                  std::string::npos);
    EXPECT_FALSE(StressSolver::build(solid, elasticMaterial(0), galerkin_gmls).ok());
    EXPECT_FALSE(StressSolver::build(solid, elasticMaterial(NAN), galerkin_gmls).ok());
    const auto mixed = form(TestFunction::heaviside, TrialFunction::gmls);
    EXPECT_NE(StressSolver::build(solid, elasticMaterial(), mixed).error().find("heaviside with mls"),
              std::string::npos);
    const StressSolver solver = build(solid, elasticMaterial(), galerkin_gmls);
    EXPECT_NE(solver.solve({{{0, 0, 0}, {NAN, 0, 0}}}).error().find("load on the body"), std::string::npos);
    EXPECT_FALSE(solver.solve({{{0, 0, 9}, {1, 0, 0}}}).ok());
    EXPECT_FALSE(solver.solve({{{0, 0, 0.5}, {1e308, 1e308, 0}}, {{0, 0, -0.5}, {1e308, -1e308, 0}}}).ok());
}

}  // namespace
}  // namespace sherd::validation
