#include "core/mlpg/splines/spline_space.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/mlpg/splines/part_integrals.h"
#include "core/mlpg/splines/spline_field.h"
#include "core/mlpg/splines/spline_support.h"

namespace sherd {
namespace {

/// Unknowns of a displacement that is linear in x: read at the Greville points.
Eigen::VectorXd linearUnknowns(const SplineSpace& space, const Mat3& gradient) {
    Eigen::VectorXd unknowns(3L * space.function_count);
    for (int f = 0; f < space.function_count; ++f)
        unknowns.segment<3>(3L * f) = gradient * space.greville_points[f];
    return unknowns;
}

TEST(SplineSpace, LinearDisplacementsHaveTheirGradientEverywhere) {
    Mat3 gradient;
    gradient << 1, 2, 3, 4, 5, 6, 7, 8, 10;
    for (int degree = 1; degree <= 3; ++degree) {
        const CellParts solid = partsOf(tiltedBox(), 0.14, degree);
        const auto space = std::make_shared<SplineSpace>(solid, degree);
        EXPECT_LT(space->function_count, space->raw_count) << "some functions see slivers only, and are tied";
        const SplineField field{
            std::make_shared<CellParts>(solid), space, space->expand(linearUnknowns(*space, gradient)), {}};
        for (size_t p = 0; p < solid.parts.size(); ++p) {
            const Mat3 got = gradientOn(field, static_cast<int>(p), Vec3(0.2, -0.3, 0.4));
            EXPECT_LT((got - gradient).norm(), 1e-10 * gradient.norm());
        }
    }
}

/// A blade that tapers to an edge: 1 x 0.6, 0.2 thick at its back.
TriangleMesh blade() {
    TriangleMesh mesh;
    for (const double y : {0.0, 0.6}) {
        mesh.vertices.emplace_back(0, y, 0);
        mesh.vertices.emplace_back(1, y, -0.1);
        mesh.vertices.emplace_back(1, y, 0.1);
    }
    mesh.triangles = {{0, 1, 2}, {3, 5, 4}, {0, 3, 4}, {0, 4, 1}, {1, 4, 5}, {1, 5, 2}, {2, 5, 3}, {2, 3, 0}};
    return shapes::moved(mesh, someRotation());
}

// Where a blade ends, well-filled cells hold next to nothing of functions that begin there.
TEST(SplineSpace, FunctionsThatCarryUnknownsAreHeldByTheSolid) {
    for (double spacing = 0.05; spacing < 0.1; spacing += 0.002) {
        const CellParts solid = partsOf(blade(), spacing, 2);
        const RawFunctions raw(solid, 2);
        const SplineTies ties(solid, raw);
        const PartIntegrals integrals(2, solid.edges);
        std::vector<double> squares(raw.count(), 0.0);
        for (size_t part = 0; part < solid.parts.size(); ++part) {
            const Eigen::VectorXd own = integrals.squares(solid.parts[part]);
            for (int n = 0; n < raw.perPart(); ++n) squares[raw.of_part[part][n]] += own[n];
        }
        double least = 1;
        for (const int function : ties.raw_of_function) least = std::min(least, squares[function]);
        EXPECT_GT(least, 1e-8) << "at a spacing of " << spacing;
    }
}

TEST(SplineSpace, NothingIsSharedAcrossAGap) {
    // Two plates with an air gap of half a cell between them.
    const TriangleMesh plates = shapes::joined(shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 0.2)),
                                               shapes::box(Vec3(0, 0, 0.25), Vec3(1, 1, 0.45)));
    const CellParts solid = partsOf(plates, 0.1, 2);
    const SplineSpace space(solid, 2);
    EXPECT_EQ(space.component_count, 2);
    for (size_t p = 0; p < solid.parts.size(); ++p)
        for (const int raw : space.raw_of[p])
            for (const SplineTies::Term& term : space.termsOf(raw))
                EXPECT_EQ(space.component[term.function], space.component_of_part[p]);
}

}  // namespace
}  // namespace sherd
