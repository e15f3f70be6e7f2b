#include <string>

#include "support/case_reference.h"
#include "validation/support.h"

namespace sherd::validation {
namespace {

double error(const StressSolver& solver, const std::vector<PointForce>& loads, const std::string& file) {
    const CaseReference reference =
        readReference(std::string(SHERD_TEST_DATA) + "/cases/slab_centre/" + file);
    EXPECT_GT(reference.points.size(), 300u);
    const StressField field = valueOf(solver.solve(loads, reference.points));
    double difference = 0, norm = 0;
    for (size_t i = 0; i < reference.points.size(); ++i) {
        difference += std::pow(largestPrincipal(field.points[i]) - reference.largest_principal[i], 2);
        norm += std::pow(reference.largest_principal[i], 2);
    }
    return std::sqrt(difference / norm);
}

/// 10 n spread over the disc of radius 0.08 m in the middle of the upper face.
std::vector<PointForce> blow() {
    std::vector<PointForce> loads;
    for (int i = 0; i < 16; ++i)
        for (int j = 0; j < 16; ++j) {
            const Vec3 x(0.01 * (i - 7.5), 0.01 * (j - 7.5), 0.045);
            if (x.head<2>().norm() < 0.08) loads.push_back({x, {0, 0, -1}});
        }
    for (PointForce& load : loads) load.force *= 1e4 / static_cast<double>(loads.size());
    return loads;
}

// A plate of nu 0.43 in biaxial bending, against quadratic finite elements converged to 1 %.
TEST(SlabCentre, Gmls) {
    const auto solid = sampled(shapes::slab({1, 1, 0.09}), 0.06);
    const StressSolver solver = build(solid, elasticMaterial(5e9, 0.43), galerkin_gmls);
    EXPECT_LT(error(solver, blow(), "reference.csv"), 0.12);
    EXPECT_LT(error(solver, blow(), "reference_surface.csv"), 0.10);
}

TEST(SlabCentre, MlsThreeAcross) {
    const auto solid = sampled(shapes::slab({1, 1, 0.09}), 0.03);
    const StressSolver solver = build(solid, elasticMaterial(5e9, 0.43), galerkin_mls);
    EXPECT_LT(error(solver, blow(), "reference.csv"), 0.14);
    EXPECT_LT(error(solver, blow(), "reference_surface.csv"), 0.20);
}

}  // namespace
}  // namespace sherd::validation
