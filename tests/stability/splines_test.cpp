#include "stability/sweep.h"

namespace sherd::stability {
namespace {

// Toward nu 0.5: above 0.45 the volumetric strain is projected, and nothing grows with 1 / (1 - 2 nu) any
// more. Above 0.499 it is refused.
TEST(PoissonRatio, FromZeroToTheLimit) {
    Table table("nu | bent plate, 2 layers | 3 layers | cubic, 2 layers | 1/condition | warnings");
    for (const double nu : {0.0, 0.2, 0.3, 0.43, 0.45, 0.48, 0.49, 0.499}) {
        const ClosedForm plate = turned(bentPlate(nu, 0.5), someRotation());
        const Outcome two = solveAt(plate, 0.06, quadratic_splines),
                      three = solveAt(plate, 0.04, quadratic_splines);
        const Outcome cubic = solveAt(plate, 0.06, splines(Basis::cubic));
        table.row("%.3f | %.4f | %.4f | %.4f | %.0e | %zu", nu, two.error, three.error, cubic.error,
                  two.reciprocal_condition, two.warnings);
        EXPECT_LT(three.error, two.error);
        EXPECT_LT(two.error, nu > 0.45 ? 0.002 : 0.008);
        EXPECT_EQ(two.warnings, 0u);
    }
    const auto block = sampledForSplines(shapes::slab({1, 1, 1}), 0.5, Basis::quadratic);
    for (const double nu : {0.4995, 0.5, 0.7, -1.0, double(NAN)}) {
        const auto refused = StressSolver::build(block, elasticMaterial(5e9, nu), quadratic_splines);
        ASSERT_FALSE(refused.ok()) << nu;
        EXPECT_NE(refused.error().find("Poisson's ratio"), std::string::npos) << refused.error();
    }
}

/// A block on a plinth whose top ends a fraction of a cell above a plane of the grid.
TriangleMesh stepped(double cut) {
    // Bounds 0.8 x 0.8 x 0.8, spacing 0.1: the grid's planes lie at multiples of 0.1.
    return shapes::rectilinear({0, 0.8}, {0, 0.3, 0.8}, {0, 0.4 + 0.1 * cut, 0.8},
                               [](int, int j, int k) { return k == 0 || j == 0; });
}

// Cells that hold next to nothing of the solid: their functions are continued from full ones, and the
// condition stays.
TEST(CutCells, SliversDownToAHundredThousandth) {
    const Mat3 stress = (Mat3() << 2, 1, 0, 1, -1, 0.5, 0, 0.5, 3).finished() * 1e6;
    Table table("part of the cell that is solid | constant stress | 1/condition");
    double best = 0, worst = 1;
    for (const double cut : {0.5, 0.25, 0.1, 1e-2, 1e-3, 1e-4, 1e-5}) {
        const ClosedForm constant{stepped(cut), elasticMaterial(), [&](const Vec3&) { return stress; }};
        const Outcome outcome = solveAt(constant, 0.1, quadratic_splines);
        table.row("%.0e | %.0e | %.0e", cut, outcome.error, outcome.reciprocal_condition);
        EXPECT_LT(outcome.error, 1e-8);
        best = std::max(best, outcome.reciprocal_condition);
        worst = std::min(worst, outcome.reciprocal_condition);
    }
    EXPECT_GT(worst, 0.01 * best);
}

// The body moved through its grid: the error must not jump anywhere.
TEST(CutCells, GridShift) {
    Table table("shift of the grid (cells) | bent plate");
    double least = 1, most = 0;
    for (int step = 0; step < 10; ++step) {
        // A corner piece that sticks out shifts the grid under the plate, whose thickness is no multiple of a
        // cell.
        const double shift = 0.005 * step;
        ClosedForm plate = bentPlate(0.43);
        plate.surface =
            shapes::rectilinear({-0.5, 0.45, 0.5}, {-0.5, 0.45, 0.5}, {-0.06, 0.06, 0.0601 + shift},
                                [](int i, int j, int k) { return k == 0 || (i == 1 && j == 1); });
        const Outcome outcome = solveAt(plate, 0.05, quadratic_splines);
        table.row("%.1f | %.4f", 0.1 * step, outcome.error);
        least = std::min(least, outcome.error);
        most = std::max(most, outcome.error);
    }
    EXPECT_LT(most, 0.03);
    EXPECT_LT(most, 3 * least);
}

/// Stress in a bar that is squeezed between two small patches on its ends: on its middle section, where it is
/// F / A (Saint-Venant), and under a patch.
struct SqueezedBar {
    std::vector<SymmetricTensor> middle, near;
};
SqueezedBar squeezedBar(double spacing, int rounds) {
    const auto solid = sampledForSplines(shapes::slab({1.2, 0.2, 0.2}), spacing, Basis::quadratic);
    StressSettings settings = quadratic_splines;
    settings.resampling_rounds = rounds;
    std::vector<PointForce> loads;
    for (const double end : {-1.0, 1.0})
        for (int i = 0; i < 25; ++i)
            loads.push_back({{0.6 * end, 0.008 * (i % 5 - 2), 0.008 * (i / 5 - 2)}, {-1e4 / 25 * end, 0, 0}});
    std::vector<Vec3> points;
    for (int i = 0; i < 9; ++i) points.emplace_back(0.01, 0.04 * (i % 3 - 1), 0.04 * (i / 3 - 1));
    for (int i = 0; i < 9; ++i) points.emplace_back(0.56, 0.02 * (i % 3 - 1), 0.02 * (i / 3 - 1));
    const StressField field = valueOf(build(solid, elasticMaterial(), settings).solve(loads, points));
    return {{field.points.begin(), field.points.begin() + 9}, {field.points.begin() + 9, field.points.end()}};
}

// Resampling joins cells of different size. Far away nothing may change; near the load each round has to
// bring the stress nearer to that of a grid that is fine everywhere.
TEST(Octree, EveryRoundHelpsNearTheLoadAndHarmsNothingElsewhere) {
    const SqueezedBar fine = squeezedBar(0.025, 0);
    Table table("rounds | middle of the bar | under the load");
    double before = std::numeric_limits<double>::infinity();
    for (const int rounds : {0, 1, 2}) {
        const SqueezedBar bar = squeezedBar(0.1, rounds);
        Squares middle, near;
        for (size_t i = 0; i < bar.middle.size(); ++i) {
            middle.add(toMatrix(bar.middle[i]), -1e4 / 0.04 * Vec3::UnitX() * Vec3::UnitX().transpose(), 1);
            near.add(toMatrix(bar.near[i]), toMatrix(fine.near[i]), 1);
        }
        table.row("%d | %.0e | %.3f", rounds, middle.ratio(), near.ratio());
        EXPECT_LT(middle.ratio(), 5e-3);
        EXPECT_LT(near.ratio(), before);
        before = near.ratio();
    }
    EXPECT_LT(before, 0.25);
}

// Next to its border little of the finer grid may move, and the more so toward nu 0.5: the coarser one is
// read there.
TEST(Octree, FinerGridIsNotReadAtItsBorder) {
    const auto solid = sampledForSplines(shapes::slab({1.2, 0.2, 0.2}), 0.1, Basis::quadratic);
    StressSettings settings = quadratic_splines;
    settings.resampling_rounds = 1;
    const std::vector<PointForce> loads{{{0.6, 0, 0}, {-1e4, 0, 0}}, {{-0.6, 0, 0}, {1e4, 0, 0}}};
    // The finer grid begins two cells from the load, at 0.4.
    const std::vector<Vec3> points{{0.3, 0.05, 0}, {0.42, 0.05, 0}, {0.48, 0.05, 0}, {0.58, 0.05, 0}};
    const StressField field = valueOf(build(solid, elasticMaterial(), settings).solve(loads, points));
    const double coarse = field.point_spacing_m[0];
    EXPECT_DOUBLE_EQ(field.point_spacing_m[1], coarse);
    EXPECT_DOUBLE_EQ(field.point_spacing_m[2], coarse / 2);
    EXPECT_DOUBLE_EQ(field.point_spacing_m[3], coarse / 2);
}

// From one particle up: constant stress is right in bodies of any number, in plates and rods of one layer
// too.
TEST(BodySize, FromOneParticleUp) {
    const Mat3 stress = (Mat3() << 2, 1, 0, 1, -1, 0.5, 0, 0.5, 3).finished() * 1e6;
    Table table("body | particles | constant stress: splines | gmls | 1/condition");
    const std::tuple<const char*, Vec3, double> bodies[] = {{"crumb", {1, 1, 1}, 1.0},
                                                            {"two", {2, 1, 1}, 1.0},
                                                            {"coplanar", {5, 4, 1}, 1.0},
                                                            {"collinear", {6, 1, 1}, 1.0},
                                                            {"cube of 2", {2, 2, 2}, 1.0},
                                                            {"cube of 3", {3, 3, 3}, 1.0},
                                                            {"sheet, 1 : 50", {50, 50, 1}, 5.0},
                                                            {"needle, 1 : 100", {100, 1, 1}, 4.0},
                                                            {"larger than itself", {1, 1, 1}, 50.0}};
    for (const auto& [name, size, spacing] : bodies) {
        const ClosedForm constant{shapes::slab(size), elasticMaterial(), [&](const Vec3&) { return stress; }};
        const auto solid = sampledForSplines(constant.surface, spacing, Basis::quadratic);
        const Outcome spline = solveOn(constant, solid, quadratic_splines);
        const Outcome gmls = has_particle_forms ? solveOn(constant, solid, galerkin_gmls) : Outcome{};
        table.row("%s | %zu | %.0e | %.0e | %.0e", name, solid->particles.size(), spline.error, gmls.error,
                  spline.reciprocal_condition);
        EXPECT_LT(spline.error, 1e-6) << name;
    }
}

// Stiffness and size over many orders: the same relative result.
TEST(Contrast, StiffnessAndSize) {
    Table table("E (Pa) | length (m) | bent plate | 1/condition");
    double first = 0;
    for (const double stiffness : {1e6, 1e9, 1e12})
        for (const double length : {1e-3, 1.0, 100.0}) {
            const ClosedForm unit = turned(bentPlate(0.3), someRotation());
            ClosedForm scaled = unit;
            for (Vec3& v : scaled.surface.vertices) v *= length;
            scaled.material = elasticMaterial(stiffness, 0.3);
            scaled.stress = [unit, length](const Vec3& x) { return unit.stress(x / length); };
            const Outcome outcome = solveAt(scaled, 0.06 * length, quadratic_splines);
            table.row("%.0e | %g | %.6f | %.0e", stiffness, length, outcome.error,
                      outcome.reciprocal_condition);
            if (first == 0) first = outcome.error;
            EXPECT_NEAR(outcome.error, first, 1e-8);
        }
}

}  // namespace
}  // namespace sherd::stability
