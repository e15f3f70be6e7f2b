#include <algorithm>
#include <cmath>

#include "geometry/repair/support.h"

namespace {

using namespace sherd;
using namespace sherd::repair_tests;

TEST(Repair, StitchesTrianglesThatOnlyLieAtEachOther) {
    TriangleMesh soup;
    const TriangleMesh ball = shapes::icosphere(1, 2);
    for (std::size_t t = 0; t < ball.triangles.size(); ++t) {
        for (const int corner : ball.triangles[t])
            // A float's rounding apart, which differs from triangle to triangle.
            soup.vertices.push_back(ball.vertices[corner] + 1e-7 * std::sin(double(t)) * Vec3(1, 1, 1));
        const int first = static_cast<int>(3 * t);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    expectRefusedUntouched(soup, "is open");
    const RepairedMesh result = repaired(soup);
    EXPECT_EQ(result.mesh.vertices.size(), ball.vertices.size());
    EXPECT_EQ(result.mesh.triangles.size(), ball.triangles.size());
    EXPECT_EQ(result.report.filled_holes, 0);
    EXPECT_NEAR(volumeOf(result.mesh), volumeOf(ball), 1e-5);
}

TEST(Repair, StitchingLeavesAloneWhatIsClosed) {
    TriangleMesh ball = shapes::icosphere(1, 2);
    const double whole = volumeOf(ball);
    ball.triangles.pop_back();
    // A leaf that is thinner than what is stitched.
    const TriangleMesh leaf = shapes::box(Vec3(2, 0, 0), Vec3(3, 1, 2e-5));
    const RepairedMesh result = repaired(shapes::joined(ball, leaf));
    EXPECT_EQ(result.report.merged_vertices, 0);
    EXPECT_EQ(result.mesh.triangles.size(), ball.triangles.size() + 1 + leaf.triangles.size());
    EXPECT_NEAR(volumeOf(result.mesh), whole + 2e-5, 1e-9);
}

TEST(Repair, TakesOutDoubledTriangles) {
    TriangleMesh mesh = unit_box;
    mesh.triangles.push_back(mesh.triangles[3]);
    mesh.triangles.push_back({mesh.triangles[5][1], mesh.triangles[5][0], mesh.triangles[5][2]});
    expectRefusedUntouched(mesh, "not a manifold");
    const RepairedMesh result = repaired(mesh);
    EXPECT_EQ(result.report.doubled_triangles, 2);
    EXPECT_EQ(result.mesh.triangles.size(), unit_box.triangles.size());
}

TEST(Repair, TakesOutAWallBetweenTwoParts) {
    const TriangleMesh mesh = sharing(unit_box, shapes::translated(unit_box, Vec3(1, 0, 0)));
    expectRefusedUntouched(mesh, "not a manifold");
    const RepairedMesh result = repaired(mesh);
    EXPECT_EQ(result.report.doubled_triangles, 4);
    EXPECT_EQ(result.mesh.triangles.size(), 20u);
    EXPECT_NEAR(volumeOf(result.mesh), 2, 1e-12);
}

TEST(Repair, TakesOutAWallOfManyTriangles) {
    const TriangleMesh box = shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 1), 3, 3, 3);
    const RepairedMesh result = repaired(sharing(box, shapes::translated(box, Vec3(1, 0, 0))));
    EXPECT_EQ(result.report.doubled_triangles, 36) << "also those that do not touch the wall's rim";
    EXPECT_NEAR(volumeOf(result.mesh), 2, 1e-12);
}

TEST(Repair, AFinWithoutThicknessIsNoWallInsideAndItsLossIsTold) {
    TriangleMesh mesh = unit_box;
    const auto corner = [&](double x) {
        return static_cast<int>(std::find(mesh.vertices.begin(), mesh.vertices.end(), Vec3(x, 0, 1)) -
                                mesh.vertices.begin());
    };
    const int a = corner(0), b = corner(1);
    mesh.vertices.insert(mesh.vertices.end(), {Vec3(1, 0, 1.5), Vec3(0, 0, 1.5)});
    for (const auto& t : {std::array<int, 3>{a, b, 8}, {a, 8, 9}}) {
        mesh.triangles.push_back(t);
        mesh.triangles.push_back({t[1], t[0], t[2]});
    }
    const RepairedMesh result = repaired(mesh);
    EXPECT_EQ(result.report.doubled_triangles, 2) << "a wall inside would go with both of its faces";
    EXPECT_NEAR(volumeOf(result.mesh), 1, 5e-3);
    EXPECT_NEAR(result.report.largest_loss_m, 0.5, 0.005);
}

}  // namespace
