#include "core/loads/load_patch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/shapes.h"

namespace {

using namespace sherd;

constexpr double pi = 3.14159265358979323846;

TriangleMesh box(const Vec3& half, int n) {
    return shapes::box(-half, half, n, n, n);
}

TEST(LoadPatch, ForcesAddUpAndStayOnTheFaceThatIsPushed) {
    const TriangleMesh mesh = box(Vec3(0.5, 0.5, 0.02), 3);
    const Vec3 push = -Vec3::UnitZ();
    const SurfaceSpot spot = nearestSurfacePoint(SurfaceTree(mesh), Vec3(0.1, -0.2, 0.05), push);
    EXPECT_TRUE(spot.point.isApprox(Vec3(0.1, -0.2, 0.02), 1e-12));
    const auto points =
        spreadForce(partsOfPatch(SurfaceTree(mesh), spot, push, 0.08, 0.18), spot, Vec3(1, 2, -30));
    Vec3 sum = Vec3::Zero(), centre = Vec3::Zero();
    for (const PointForce& p : points) {
        sum += p.force;
        centre += p.position * (p.force.z() / -30);
        EXPECT_NEAR(p.position.z(), 0.02, 1e-12);
        EXPECT_LE((p.position - spot.point).norm(), 0.08 + 1e-12);
    }
    EXPECT_GT(points.size(), 20u);
    EXPECT_TRUE(sum.isApprox(Vec3(1, 2, -30), 1e-12));
    EXPECT_LT((centre - spot.point).norm(), 0.01);
}

/// Of all that presses on a patch at the edge of a box: on the side, and the radius of curvature there.
struct AtTheEdge {
    double on_side = 0, radius_m = 0;
};

AtTheEdge pressedNearTheEdge(double tilt) {
    const TriangleMesh mesh = box(Vec3(0.5, 0.5, 0.5), 3);
    const SurfaceTree tree(mesh);
    const Vec3 push = Vec3(-tilt, 0, -1).normalized(), close(0.495, 0.1, 0.5);
    const SurfaceSpot spot = nearestSurfacePoint(tree, close, -Vec3::UnitZ());
    AtTheEdge found{0, contactRadius(tree, spot.point, push, 0.05, 0.002)};
    for (const PointForce& p : spreadForce(partsOfPatch(tree, spot, push, 0.02, 0.18), spot, push))
        if (p.position.z() < 0.5 - 1e-9) found.on_side += p.force.norm();
    return found;
}

/// Else the least turn of a push would move a part of it to another face.
TEST(LoadPatch, TheSideOfABoxIsPressedAsMuchAsItFacesThePush) {
    const AtTheEdge straight = pressedNearTheEdge(0);
    EXPECT_EQ(straight.on_side, 0);
    double before = 0;
    for (const double tilt : {-1e-6, 1e-6, 0.01, 0.1, 0.3, 0.6, 1.0}) {
        const AtTheEdge tilted = pressedNearTheEdge(tilt);
        EXPECT_GE(tilted.on_side, before) << tilt;
        EXPECT_LT(tilted.on_side - before, 0.2) << tilt;
        before = tilted.on_side;
        if (std::abs(tilt) < 1e-3) {
            EXPECT_NEAR(tilted.radius_m, straight.radius_m, 1e-3 * straight.radius_m) << tilt;
        }
    }
    EXPECT_GT(before, 0.3) << "at 45 degrees about half of what the edge leaves of the patch";
}

TEST(LoadPatch, APlaneTouchesTheRimOfAHollow) {
    TriangleMesh mesh = box(Vec3(0.5, 0.5, 0.5), 4);
    for (Vec3& v : mesh.vertices)  // hollow the bottom out, but for its rim
        if (v.z() < -0.49 && std::max(std::abs(v.x()), std::abs(v.y())) < 0.49) v.z() = -0.4;
    const SurfaceTree tree(mesh);
    const Vec3 middle(0.1, 0, -0.5);
    EXPECT_LT(std::abs(nearestSurfacePoint(tree, middle, Vec3::UnitZ()).point.x()), 0.3);
    const SurfaceSpot rim = touchedByAPlane(tree, middle, Vec3::UnitZ(), 0.01);
    EXPECT_TRUE(rim.point.isApprox(Vec3(0.5, 0, -0.5), 1e-12));
    EXPECT_GE(rim.triangle, 0);
    EXPECT_LT(touchedByAPlane(tree, Vec3(0, 0, -0.6), Vec3::UnitZ(), 0.01).triangle, 0) << "touches nothing";
}

TEST(LoadPatch, APatchWithoutSurfaceIsOnePoint) {
    const TriangleMesh mesh = box(Vec3(1, 1, 1), 1);
    const SurfaceSpot spot{Vec3(0, 0, 9), 0};
    const auto points =
        spreadForce(partsOfPatch(SurfaceTree(mesh), spot, -Vec3::UnitZ(), 0.1, 0.18), spot, Vec3(0, 0, -1));
    ASSERT_EQ(points.size(), 1u);
    EXPECT_TRUE(points[0].force.isApprox(Vec3(0, 0, -1)));
}

TEST(LoadPatch, CurvatureIsLargeOnAFaceAndSmallAtAnEdge) {
    const TriangleMesh mesh = box(Vec3(0.5, 0.5, 0.5), 4);
    const double face = contactRadius(SurfaceTree(mesh), Vec3(0, 0, 0.5), -Vec3::UnitZ(), 0.2, 0.002);
    EXPECT_NEAR(face, pi * 0.04 / (2 * pi * 0.002), 0.3 * face);
    const Vec3 edge_push = Vec3(-1, 0, -1).normalized();
    EXPECT_LT(contactRadius(SurfaceTree(mesh), Vec3(0.5, 0, 0.5), edge_push, 0.2, 0.002), 0.2 * face);
    const Vec3 corner_push = Vec3(-1, -1, -1).normalized();
    EXPECT_LT(contactRadius(SurfaceTree(mesh), Vec3(0.5, 0.5, 0.5), corner_push, 0.2, 0.002), 0.01);
}

}  // namespace
