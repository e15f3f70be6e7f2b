#include <array>
#include <utility>
#include <vector>

#include "geometry/repair/support.h"
#include "geometry/surface_topology.h"

namespace {

using namespace sherd;
using namespace sherd::repair_tests;

TEST(Repair, WhatIsSoundStaysBitForBit) {
    const RepairedMesh same = repaired(unit_box, Repair::automatic());
    EXPECT_EQ(same.mesh.vertices, unit_box.vertices);
    EXPECT_EQ(same.mesh.triangles, unit_box.triangles);
    EXPECT_FALSE(same.report.changed());
}

TEST(Repair, FillsHoles) {
    TriangleMesh mesh = shapes::icosphere(1, 2);
    const double whole = volumeOf(mesh);
    mesh.triangles.erase(mesh.triangles.begin() + 100);
    mesh.triangles.erase(mesh.triangles.begin() + 10, mesh.triangles.begin() + 12);
    expectRefusedUntouched(mesh, "is open");
    const RepairedMesh result = repaired(mesh);
    EXPECT_EQ(result.report.filled_holes, 2);
    EXPECT_GT(result.report.largest_hole_m, 0.2);
    EXPECT_NEAR(volumeOf(result.mesh), whole, 0.01);
    EXPECT_LT(result.report.largest_distance_m, 1e-9);
}

std::string allOf(const RepairReport& report) {
    std::string said;
    for (const std::string& sentence : report.sentences()) said += sentence + " ";
    return said;
}

TEST(Repair, SaysWhatBecameOfHolesAndPrintsNoRoundingErrors) {
    RepairReport report;
    report.filled_holes = report.united_parts = 1;
    report.largest_hole_m = 0.1414;
    report.size_m = 0.4;
    report.largest_distance_m = 2.78e-17;
    for (const char* words : {"the box around the largest has a diagonal of 0.141 m.",
                              "Repair::shell_thickness_m", "The new surface lies on the old one."})
        EXPECT_NE(allOf(report).find(words), std::string::npos) << allOf(report);
    report.largest_hole_m = 0.05;  // too small for an opening
    EXPECT_EQ(allOf(report).find("Repair::shell_thickness_m"), std::string::npos) << allOf(report);
    report.largest_hole_m = 0.1414;
    report.hollowed = true;
    EXPECT_EQ(allOf(report).find("Repair::shell_thickness_m"), std::string::npos) << allOf(report);
    EXPECT_EQ(describePlace(Vec3(2.78e-17, -1e-12, 0.25)), "(0, 0, 0.25)");
}

/// Without the triangles whose middle is where `goes` says; as many as `most`.
template <class Goes>
TriangleMesh without(TriangleMesh mesh, Goes goes, int most) {
    const auto isGone = [&](const std::array<int, 3>& t) {
        return goes((mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3) && most-- > 0;
    };
    std::vector<std::array<int, 3>> kept;
    for (const auto& triangle : mesh.triangles)
        if (!isGone(triangle)) kept.push_back(triangle);
    mesh.triangles = std::move(kept);
    return mesh;
}

TEST(Repair, AMissingTriangleIsAHoleHoweverLargeAndHalfABallIsASheet) {
    const TriangleMesh slab = shapes::slab(Vec3(1, 1, 0.09));
    const TriangleMesh open = without(
        slab, [](const Vec3& x) { return x.z() > 0.04; }, 1);
    ASSERT_EQ(open.triangles.size() + 1, slab.triangles.size());
    EXPECT_NEAR(volumeOf(repaired(open).mesh), 0.09, 1e-12);
    const TriangleMesh bowl = without(
        shapes::icosphere(1, 3), [](const Vec3& x) { return x.z() > 0; }, 1 << 30);
    EXPECT_NE(repairMesh(bowl, mendOnly()).error().find("is open"), std::string::npos);
}

TEST(Repair, PartsWhatTouchesInAPoint) {
    const TriangleMesh mesh = sharing(unit_box, shapes::translated(unit_box, Vec3(1, 1, 1)));
    expectRefusedUntouched(mesh, "single point (1, 1, 1)");
    const RepairedMesh result = repaired(mesh);
    EXPECT_EQ(result.report.parted_places, 1);
    EXPECT_NEAR(volumeOf(result.mesh), 2, 2e-3);
}

TEST(Repair, PartsWhatTouchesInAnEdge) {
    const TriangleMesh mesh = sharing(unit_box, shapes::translated(unit_box, Vec3(1, 1, 0)));
    expectRefusedUntouched(mesh, "4 triangles");
    const RepairedMesh result = repaired(mesh);
    EXPECT_GE(result.report.parted_places, 2);
    EXPECT_NEAR(volumeOf(result.mesh), 2, 5e-3);
}

TEST(Repair, PartsASolidThatTouchesItselfInAnEdge) {
    // Four cells of a ring of eight and a diagonal: joined elsewhere, so both ends of the edge stay one part.
    const TriangleMesh mesh = shapes::rectilinear(
        shapes::lines(0, 3, 3), shapes::lines(0, 3, 3), shapes::lines(0, 1, 1),
        [](int i, int j, int) { return i == 0 || j == 0 || (i == 2 && j == 1) || (i == 1 && j == 2); });
    expectRefusedUntouched(mesh, "not a manifold");
    const RepairedMesh result = repaired(mesh);
    EXPECT_GE(result.report.parted_places, 2);
    EXPECT_NEAR(volumeOf(result.mesh), 7, 2e-2);
}

TEST(Repair, PartsAnEdgeWhoseEndsStayTogether) {
    // Between two full layers two cells touch in an edge, and the layers join both ends of it.
    const TriangleMesh mesh =
        shapes::rectilinear(shapes::lines(0, 2, 2), shapes::lines(0, 2, 2), shapes::lines(0, 3, 3),
                            [](int i, int j, int k) { return k != 1 || i == j; });
    expectRefusedUntouched(mesh, "not a manifold");
    const RepairedMesh result = repaired(mesh);
    EXPECT_EQ(result.report.parted_places, 1) << "the middle of the edge";
    EXPECT_NEAR(volumeOf(result.mesh), 10, 2e-2);
}

TEST(Repair, TurnsTriangles) {
    TriangleMesh mesh = shapes::icosphere(1, 2);
    const double whole = volumeOf(mesh);
    for (const int t : {17, 100, 201}) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
    expectRefusedUntouched(mesh, "not oriented");
    const RepairedMesh result = repaired(mesh);
    EXPECT_EQ(result.report.turned_triangles, 3);
    EXPECT_NEAR(volumeOf(result.mesh), whole, 1e-12);
}

TEST(Repair, TurnsPartsOutward) {
    expectRefusedUntouched(shapes::inverted(unit_box), "inside out");
    EXPECT_NEAR(volumeOf(repaired(shapes::inverted(unit_box)).mesh), 1, 1e-12);
    const TriangleMesh far = shapes::translated(shapes::inverted(unit_box), Vec3(3, 0, 0));
    EXPECT_NEAR(volumeOf(repaired(shapes::joined(unit_box, far)).mesh), 2, 1e-12);
    // A hollow ball that is inside out as a whole keeps its cavity.
    const TriangleMesh hollow = shapes::hollowSphere(1, 0.5, 2);
    EXPECT_NEAR(volumeOf(repaired(shapes::inverted(hollow)).mesh), volumeOf(hollow), 1e-12);
}

TEST(Repair, RemovesTrianglesWithoutArea) {
    TriangleMesh mesh = unit_box;
    const int a = mesh.triangles[0][0], b = mesh.triangles[0][1];
    mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]) / 2);
    // The neighbour across a-b goes on in two triangles; between it and triangle 0 lies one without area.
    const auto neighbour = std::find_if(mesh.triangles.begin() + 1, mesh.triangles.end(), [&](const auto& t) {
        return std::count(t.begin(), t.end(), a) && std::count(t.begin(), t.end(), b);
    });
    ASSERT_NE(neighbour, mesh.triangles.end());
    auto first = *neighbour, second = *neighbour;
    std::replace(first.begin(), first.end(), a, 8);
    std::replace(second.begin(), second.end(), b, 8);
    *neighbour = first;
    mesh.triangles.push_back(second);
    mesh.triangles.push_back({b, a, 8});
    expectRefusedUntouched(mesh, "has no area");
    const RepairedMesh result = repaired(mesh);
    EXPECT_NEAR(volumeOf(result.mesh), 1, 1e-12);
    EXPECT_EQ(result.report.flat_triangles, 1);
    EXPECT_EQ(result.report.filled_holes, 0) << "its neighbours are joined";
    EXPECT_EQ(result.report.crossings, 0) << "nothing is cut out around it";
}

TEST(Repair, LeavesOutATriangleWithoutAreaThatHangsOnAnEdge) {
    TriangleMesh mesh = unit_box;
    const int a = mesh.triangles[0][0], b = mesh.triangles[0][1];
    mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]) / 2);
    mesh.triangles.push_back({a, b, 8});
    expectRefusedUntouched(mesh, "has no area");
    const RepairedMesh result = repaired(mesh);
    EXPECT_EQ(result.report.flat_triangles, 1);
    EXPECT_EQ(result.mesh.triangles.size(), unit_box.triangles.size());
    EXPECT_NEAR(volumeOf(result.mesh), 1, 1e-12);
}

TEST(Repair, UnitesPartsThatOverlap) {
    const TriangleMesh mesh = shapes::joined(shapes::box(Vec3(0, 0, 0), Vec3(2, 1, 1)),
                                             shapes::box(Vec3(1.3, 0.2, 0.3), Vec3(3, 0.7, 1.9)));
    expectRefusedUntouched(mesh, "intersects itself");
    const RepairedMesh result = repaired(mesh);
    EXPECT_EQ(result.report.united_parts, 1);
    EXPECT_NEAR(volumeOf(result.mesh), 2 + 1.7 * 0.5 * 1.6 - 0.7 * 0.5 * 0.7, 1e-9);
    EXPECT_LT(result.report.largest_distance_m, 1e-9);
    // The end of the second box is inside now; its point (1.3, 0.5, 0.5) is half a metre from all that stays.
    EXPECT_NEAR(result.report.largest_loss_m, 0.5, 0.005);
}

TEST(Repair, PartsInsideOthersAreUnitedAndCavitiesStay) {
    const TriangleMesh ball = shapes::icosphere(1, 2), core = shapes::icosphere(0.5, 1);
    expectRefusedUntouched(shapes::joined(ball, core), "lies inside another part");
    const RepairedMesh solid = repaired(shapes::joined(ball, core));
    EXPECT_EQ(solid.report.united_parts, 1);
    EXPECT_NEAR(volumeOf(solid.mesh), volumeOf(ball), 1e-12);
    const TriangleMesh open_elsewhere = shapes::joined(
        shapes::hollowSphere(1, 0.5, 2), shapes::inverted(shapes::translated(core, Vec3(3, 0, 0))));
    const RepairedMesh hollow = repaired(open_elsewhere);
    EXPECT_NEAR(volumeOf(hollow.mesh), volumeOf(shapes::hollowSphere(1, 0.5, 2)) + volumeOf(core), 1e-12);
}

TEST(Repair, ABallInACavityStays) {
    const TriangleMesh hollow = shapes::hollowSphere(1, 0.5, 2);
    TriangleMesh ball = shapes::icosphere(0.2, 1);
    const double whole = volumeOf(hollow) + volumeOf(ball);
    ball.triangles.pop_back();
    const RepairedMesh result = repaired(shapes::joined(hollow, ball));
    EXPECT_EQ(result.report.filled_holes, 1);
    EXPECT_EQ(result.report.united_parts, 0) << "it is in the open, not in material";
    EXPECT_NEAR(volumeOf(result.mesh), whole, 1e-12);
}

TEST(Repair, UndoesASmallFold) {
    TriangleMesh mesh = shapes::icosphere(1, 3);
    const double whole = volumeOf(mesh);
    // A vertex is dragged along the surface past its neighbours.
    const int v = mesh.triangles[40][0];
    mesh.vertices[v] = (mesh.vertices[v] + 0.45 * mesh.vertices[v].unitOrthogonal()).normalized();
    expectRefusedUntouched(mesh, "intersects itself");
    const RepairedMesh result = repaired(mesh);
    EXPECT_GT(result.report.crossings, 0);
    EXPECT_NEAR(volumeOf(result.mesh), whole, 0.02);
    EXPECT_LT(result.report.largest_distance_m, 0.05);
    EXPECT_GT(result.report.largest_distance_m, 1e-4);
}

}  // namespace
