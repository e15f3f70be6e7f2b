#include "validation/support.h"

namespace sherd::validation {
namespace {

constexpr double inner = 0.1, outer = 0.2, pressure = 1e6;

struct Errors {
    double interior, surface;
};

/// Relative L2 errors of the largest principal stress (Lame: the hoop stress) of a tube under inner pressure.
Errors lameErrors(const StressSettings& settings, double spacing) {
    const auto solid = sampled(shapes::tube(outer, inner, 0.2, 96), spacing);
    const StressField field =
        valueOf(build(solid, elasticMaterial(5e9, 0.43), settings)
                    .solveTraction([](const Vec3& x, const Vec3& normal) {
                        return x.head<2>().norm() < (inner + outer) / 2 && std::abs(normal.z()) < 0.5
                                   ? Vec3(-pressure * normal)
                                   : Vec3(Vec3::Zero());
                    }));
    double error[2] = {0, 0}, norm[2] = {0, 0};
    const auto compare = [&](int kind, const Vec3& x, const SymmetricTensor& stress) {
        const double radius = std::max(inner, x.head<2>().norm());
        const double hoop = pressure * inner * inner / (outer * outer - inner * inner) *
                            (1 + outer * outer / (radius * radius));
        error[kind] += std::pow(largestPrincipal(stress) - hoop, 2);
        norm[kind] += hoop * hoop;
    };
    for (size_t i = 0; i < solid->particles.size(); ++i)
        compare(0, solid->particles[i].position, field.particles[i]);
    for (size_t i = 0; i < solid->surface_points.size(); ++i)
        compare(1, solid->surface_points[i].position, field.surface[i]);
    return {std::sqrt(error[0] / norm[0]), std::sqrt(error[1] / norm[1])};
}

TEST(ThickCylinder, GmlsConverges) {
    const Errors coarse = lameErrors(galerkin_gmls, 0.05), fine = lameErrors(galerkin_gmls, 0.1 / 3);
    EXPECT_LT(coarse.interior, 0.16);
    EXPECT_LT(fine.interior, 0.08);
    EXPECT_LT(fine.surface, 0.16);
    EXPECT_LT(fine.interior, coarse.interior);
    EXPECT_LT(fine.surface, coarse.surface);
}

TEST(ThickCylinder, Mls) {
    const Errors errors = lameErrors(galerkin_mls, 0.025);
    EXPECT_LT(errors.interior, 0.12);
    EXPECT_LT(errors.surface, 0.25);
}

// No bending here, so the paper's test functions do well on cut cells.
TEST(ThickCylinder, Heaviside) {
    const Errors errors = lameErrors(heaviside_mls, 0.025);
    EXPECT_LT(errors.interior, 0.12);
    EXPECT_LT(errors.surface, 0.25);
}

}  // namespace
}  // namespace sherd::validation
