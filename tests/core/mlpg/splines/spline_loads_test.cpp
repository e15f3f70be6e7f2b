#include "core/mlpg/splines/spline_loads.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/mlpg/splines/spline_support.h"

namespace sherd {
namespace {

// Every raw function gets its share of a body force, and shares add up to 1.
TEST(SplineLoads, BodyForcesAddUpToForceTimesVolume) {
    const CellParts solid = partsOf(tiltedBox(), 0.14, 2);
    const SplineSpace space(solid, 2);
    AffineForce force;
    force.value = Vec3(1, -2, 3);
    const Vec3 sum = bodyForcesAt(solid, space, {solid.parts.size(), force}).rowwise().sum();
    EXPECT_LT((sum - 1 * 0.6 * 0.4 * force.value).norm(), 1e-12);
}

// A sliver of the finer grid may lie where the coarser one has nothing near: it belongs to the same body and
// is under the same acceleration, and the functions that it shares with others keep their force.
TEST(SplineLoads, PartsWithoutAParentAreUnderTheForceOfTheirComponent) {
    const TriangleMesh two = shapes::joined(shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 0.3)),
                                            shapes::box(Vec3(0, 0, 0.5), Vec3(1, 1, 0.8)));
    const CellParts solid = partsOf(two, 0.1, 2);
    const SplineSpace space(solid, 2);
    ASSERT_EQ(space.component_count, 2);
    BodyLoads coarse;
    for (const int component : space.component_of_part) {
        coarse.body_forces.emplace_back();
        coarse.body_forces.back().value = component == 0 ? Vec3(1, 0, 0) : Vec3(0, 5, 0);
    }
    std::vector<int> parents(solid.parts.size());
    std::iota(parents.begin(), parents.end(), 0);
    for (size_t part = 0; part < parents.size(); part += 7) parents[part] = -1;
    const BodyLoads inside = loadsInside(solid, space, parents, coarse);
    const Vec3 sum = bodyForcesAt(solid, space, inside.body_forces).rowwise().sum();
    EXPECT_LT((sum - Vec3(0.3, 1.5, 0)).norm(), 1e-12);
}

}  // namespace
}  // namespace sherd
