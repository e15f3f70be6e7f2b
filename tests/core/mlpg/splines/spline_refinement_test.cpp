#include "core/mlpg/splines/spline_refinement.h"

#include <gtest/gtest.h>

#include "core/linear_algebra/dense.h"
#include "core/mlpg/splines/spline_field.h"
#include "core/mlpg/splines/spline_support.h"
#include "core/sampling/cell_moments.h"

namespace sherd {
namespace {

// The refined grid can say all that the coarse one says.
TEST(SplineRefinement, KeepsTheDisplacement) {
    const TriangleMesh mesh = tiltedBox();
    for (int degree = 1; degree <= 3; ++degree) {
        const CellParts coarse = partsOf(mesh, 0.2, degree);
        const auto space = std::make_shared<SplineSpace>(coarse, degree);
        const SplineField field{std::make_shared<CellParts>(coarse),
                                space,
                                space->expand(randomVector(3L * space->function_count, 3)),
                                {}};
        const Result<CellParts> fine =
            refineCellParts(mesh, coarse, Eigen::Vector3i(1, 1, 1), Eigen::Vector3i(4, 4, 3));
        ASSERT_TRUE(fine.ok()) << fine.error();
        const auto fine_space = std::make_shared<SplineSpace>(fine.value(), degree);
        const std::vector<int> parents = parentParts(coarse, fine.value());
        const SplineField refined{
            std::make_shared<CellParts>(fine.value()),
            fine_space,
            refinedCoefficients(coarse, *space, field.raw, fine.value(), *fine_space, parents),
            {}};
        ASSERT_GT(fine.value().parts.size(), 20u);
        double volume = 0, box_volume = 0;
        for (size_t p = 0; p < fine.value().parts.size(); ++p) {
            const CellPart& part = fine.value().parts[p];
            volume += part.fill;
            const Vec3 xi(0.1, -0.2, 0.3);
            const Vec3 x =
                fine.value().origin +
                (part.cell.cast<double>() + Vec3::Constant(0.5) + xi).cwiseProduct(fine.value().edges);
            const CellPart& parent = coarse.parts[parents[p]];
            const Mat3 expected = gradientOn(field, parents[p], coarse.toCell(x, parent.cell));
            EXPECT_LT((gradientOn(refined, static_cast<int>(p), xi) - expected).norm(),
                      1e-9 * (1 + expected.norm()));
        }
        for (const CellPart& part : coarse.parts)
            if ((part.cell.array() >= 1).all() && part.cell.x() < 4 && part.cell.y() < 4 && part.cell.z() < 3)
                box_volume += 8 * part.fill;
        EXPECT_NEAR(volume, box_volume, 1e-9) << "the same solid";
    }
}

}  // namespace
}  // namespace sherd
