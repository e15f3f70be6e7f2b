#include "stability/sweep.h"

namespace sherd::stability {
namespace {

/// Largest stress in one leg of a tuning fork while the other one is bent, over the largest anywhere. Legs of
/// 0.2 x 0.2 x 1 on a base that joins them.
double stressAcrossGap(double gap, double spacing, const StressSettings& settings) {
    const double leg = 0.2, height = 1;
    const TriangleMesh fork =
        shapes::rectilinear({-leg - gap / 2, -gap / 2, gap / 2, leg + gap / 2}, {0, 0.2}, {-0.3, 0, height},
                            [](int i, int, int k) { return k == 0 || i != 1; });
    SamplingSettings sampling;
    sampling.moment_order = 4;
    const auto solid = std::make_shared<Discretisation>(valueOf(sampleSolid(fork, spacing, sampling)));
    // A couple of forces in the upper half of the left leg alone: self-balanced, so nothing is left for the
    // right leg.
    std::vector<PointForce> loads;
    for (const auto& [z, force] : {std::pair{0.95, 1.0}, {0.75, -2.0}, {0.55, 1.0}})
        loads.push_back({{-leg - gap / 2, 0.1, z}, {force * 1e4, 0, 0}});
    const StressField field = valueOf(build(solid, elasticMaterial(), settings).solve(loads));
    double other = 0, largest = 0;
    for (size_t i = 0; i < solid->particles.size(); ++i) {
        const Vec3& x = solid->particles[i].position;
        const double stress = field.particles[i].norm();
        EXPECT_TRUE(std::isfinite(stress));
        largest = std::max(largest, stress);
        if (x.x() > gap / 2 && x.z() > 0.2) other = std::max(other, stress);
    }
    return other / largest;
}

// Gaps from wide to a hundredth of a cell: nothing may pass through air.
TEST(Gaps, NothingPassesThroughAir) {
    Table table("gap (spacings) | splines: stress across | gmls: stress across");
    for (const double gap : {2.0, 1.0, 0.5, 0.1, 0.01}) {
        const double spacing = 0.1;
        const double spline = stressAcrossGap(gap * spacing, spacing, quadratic_splines);
        const double gmls = has_particle_forms ? stressAcrossGap(gap * spacing, spacing, galerkin_gmls) : 0;
        table.row("%.2f | %.0e | %.0e", gap, spline, gmls);
        EXPECT_LT(spline, 0.01);
        EXPECT_LT(gmls, 0.02);
    }
}

/// A bar with a square neck in its middle, pulled: force through the neck's section from the stress there,
/// over the load.
struct Neck {
    double carried = 0, reciprocal_condition = 0;
    size_t warnings = 0;
};
Neck pulledNeck(double width, double spacing) {
    const double half = width / 2;
    const TriangleMesh mesh =
        shapes::rectilinear({-1, -0.2, 0.2, 1}, {-0.4, -half, half, 0.4}, {-0.4, -half, half, 0.4},
                            [](int i, int j, int k) { return i != 1 || (j == 1 && k == 1); });
    const auto solid = sampledForSplines(mesh, spacing, Basis::quadratic);
    std::vector<PointForce> loads;
    for (const SurfaceNode& node : surfaceQuadrature(mesh, solid->parts))
        if (std::abs(node.position.x()) > 0.999 && std::abs(node.area.normalized().x()) > 0.9)
            loads.push_back({node.position, 1e6 * node.area});
    std::vector<Vec3> section;
    for (int i = 0; i < 16; ++i)
        section.emplace_back(0.03, (i % 4 - 1.5) / 4 * width, (i / 4 - 1.5) / 4 * width);
    const StressSolver solver = build(solid, elasticMaterial(), quadratic_splines);
    const StressField field = valueOf(solver.solve(loads, section));
    Neck neck;
    for (const SymmetricTensor& stress : field.points)
        neck.carried += stress[0] / 16 * width * width / (1e6 * 0.8 * 0.8);
    neck.reciprocal_condition = solver.report().reciprocal_condition;
    neck.warnings = field.warnings.size();
    return neck;
}

// Necks of two cells down to a fiftieth of one: they carry the load whole.
TEST(Necks, CarryTheLoad) {
    Table table("neck (spacings) | force carried | 1/condition");
    for (const double width : {2.0, 1.0, 0.5, 0.2, 0.05, 0.02}) {
        const Neck neck = pulledNeck(0.1 * width, 0.1);
        table.row("%.2f | %.3f | %.0e", width, neck.carried, neck.reciprocal_condition);
        EXPECT_NEAR(neck.carried, 1, 0.1);
        EXPECT_GT(neck.reciprocal_condition, 1e-14);
    }
}

// Two blocks that share an edge only, or a corner, with vertices of their own: there is no section that could
// carry anything, so they are two bodies, each balanced by itself.
TEST(JoinedAtAnEdge, AreTwoBodies) {
    const TriangleMesh one = shapes::box({0, 0, 0}, {1, 1, 1});
    Table table("joined at | error of constant stress | stress in the unloaded one");
    for (const auto& [name, offset] :
         {std::pair{"an edge", Vec3(1, 1, 0)}, {"a corner", Vec3(1, 1, 1)}, {"nothing", Vec3(1.5, 0, 0)}}) {
        const TriangleMesh both = shapes::joined(one, shapes::translated(one, offset));
        SamplingSettings sampling;
        sampling.moment_order = 4;
        const auto sampled_solid = sampleSolid(both, 0.25, sampling);
        ASSERT_TRUE(sampled_solid.ok()) << sampled_solid.error();
        const auto solid = std::make_shared<Discretisation>(sampled_solid.value());
        const Mat3 stress = (Mat3() << 2, 1, 0, 1, -1, 0.5, 0, 0.5, 3).finished() * 1e6;
        const ClosedForm constant{both, elasticMaterial(), [&](const Vec3&) { return stress; }};
        const Outcome outcome = solveOn(constant, solid, quadratic_splines);
        // A push without balance of its own: only the inertia of the block that it acts on may answer it.
        const StressField field = valueOf(
            build(solid, constant.material, quadratic_splines).solve({{{0.1, 0.2, 0.3}, {1e6, 2e5, 0}}}));
        double other = 0, own = 0;
        for (size_t i = 0; i < solid->particles.size(); ++i) {
            const bool is_other = ((solid->particles[i].position - offset).array() > 0).all();
            double& largest = is_other ? other : own;
            largest = std::max(largest, field.particles[i].norm());
        }
        other /= own;
        table.row("%s | %.0e | %.0e", name, outcome.error, other);
        EXPECT_LT(outcome.error, 1e-8);
        EXPECT_LT(other, 1e-8);
    }
}

// A wall thinner than the spacing, with a rim that is not: sampled by what little of each cell it fills.
TEST(ThinWalls, DownToATwentiethOfASpacing) {
    Table table("thickness (spacings) | constant stress | bending | 1/condition");
    for (const double thickness : {1.0, 0.5, 0.25, 0.1, 0.05}) {
        const Mat3 stress = (Mat3() << 2, 1, 0, 1, -1, 0, 0, 0, 0).finished() * 1e6;
        const ClosedForm plate{
            shapes::moved(shapes::slab({1, 0.7, 0.1 * thickness}), someRotation()), elasticMaterial(),
            [&](const Vec3&) -> Mat3 { return someRotation() * stress * someRotation().transpose(); }};
        const Outcome stretched = solveAt(plate, 0.1, quadratic_splines);
        const Outcome bent =
            solveAt(turned(curvedPlate(0.3, 0.1 * thickness), someRotation()), 0.1, quadratic_splines);
        table.row("%.2f | %.0e | %.0e | %.0e", thickness, stretched.error, bent.error,
                  stretched.reciprocal_condition);
        EXPECT_LT(stretched.error, 1e-5);
        EXPECT_LT(bent.error, 0.03);
    }
}

// Whatever is wrong with a load, no NaN leaves: a sentence does.
TEST(Loads, NotFiniteOrBesideTheBody) {
    const auto solid = sampledForSplines(shapes::slab({1, 1, 0.2}), 0.1, Basis::quadratic);
    const StressSolver solver = build(solid, elasticMaterial(), quadratic_splines);
    for (const PointForce& load :
         {PointForce{{0, 0, 0}, {NAN, 0, 0}}, PointForce{{NAN, 0, 0}, {1, 0, 0}},
          PointForce{{0, 0, INFINITY}, {1, 0, 0}}, PointForce{{0, 0, 9}, {1, 0, 0}}}) {
        const auto field = solver.solve({load});
        ASSERT_FALSE(field.ok());
        EXPECT_NE(field.error().find("load"), std::string::npos);
        EXPECT_EQ(field.error().find("not finite; the loads or"), std::string::npos) << "caught too late";
    }
    EXPECT_FALSE(solver.solve({{{0, 0, 0.1}, {1e308, 1e308, 0}}, {{0, 0, -0.1}, {1e308, -1e308, 0}}}).ok());
}

}  // namespace
}  // namespace sherd::stability
