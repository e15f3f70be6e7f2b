#include "geometry/surface_checks.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "support/shapes.h"

namespace {

using namespace sherd;

const TriangleMesh unit_box = shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 1));

std::string sentenceFor(const TriangleMesh& mesh) {
    return checkSurface(mesh).error();
}

std::string sentenceForFile(const std::string& name) {
    const Result<TriangleMesh> mesh = readObj(std::string(SHERD_TEST_DATA) + "/bad_obj/" + name);
    return mesh.ok() ? sentenceFor(mesh.value()) : mesh.error();
}

void expectWords(const std::string& sentence, const std::vector<std::string>& words) {
    for (const std::string& word : words)
        EXPECT_NE(sentence.find(word), std::string::npos) << "'" << word << "' in: " << sentence;
}

TEST(SurfaceChecks, SoundSolidsPass) {
    EXPECT_EQ(sentenceFor(unit_box), "");
    EXPECT_EQ(sentenceFor(shapes::moved(shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 1), 3, 4, 5), shapes::tilt())),
              "");
    EXPECT_EQ(sentenceFor(shapes::icosphere(0.1, 3)), "");
    EXPECT_EQ(sentenceFor(shapes::tube(0.05, 0.04, 0.1, 24)), "");
    EXPECT_EQ(sentenceFor(shapes::cup(0.04, 0.09, 0.005, 32, 8)), "");
    EXPECT_EQ(sentenceFor(shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 1e-6))), "");
}

TEST(SurfaceChecks, SeveralPartsAndCavitiesAreSolids) {
    EXPECT_EQ(sentenceFor(shapes::joined(unit_box, shapes::translated(unit_box, Vec3(3, 0, 0)))), "");
    EXPECT_EQ(sentenceFor(shapes::hollowSphere(1, 0.5, 2)), "");
    // A ball that rattles in a hollow ball.
    EXPECT_EQ(sentenceFor(shapes::joined(shapes::hollowSphere(1, 0.5, 2), shapes::icosphere(0.2, 2))), "");
    // The inner ball listed first.
    EXPECT_EQ(sentenceFor(shapes::joined(shapes::icosphere(0.2, 2), shapes::hollowSphere(1, 0.5, 2))), "");
}

TEST(SurfaceChecks, TheBadFilesHaveTheirSentences) {
    EXPECT_EQ(
        sentenceForFile("open.obj"),
        "The surface is open: the edge from (0, 0, 0.1) to (0.1, 0, 0.1) belongs to face 2 only (4 such "
        "edges, at faces 2, 4, 5 and 3); close the hole, or give the sheet a thickness (a vessel: "
        "Repair::shell_thickness_m).");
    EXPECT_EQ(sentenceForFile("inverted.obj"),
              "The surface is inside out: its triangles face inward, so its volume is negative; reverse the "
              "order of the "
              "corners in every face.");
    expectWords(sentenceForFile("self_intersecting.obj"),
                {"The surface intersects itself: faces ", " cross near (", "unite overlapping parts"});
    EXPECT_EQ(sentenceForFile("self_intersecting.obj").find("lies inside"), std::string::npos);
    expectWords(sentenceForFile("nan.obj"), {"nan.obj:4: the y coordinate 'nan' is not a finite number"});
    expectWords(sentenceForFile("empty.obj"), {"empty.obj: there are no faces"});
}

TEST(SurfaceChecks, NumbersThatAreNoneAreNamed) {
    expectWords(sentenceFor({}), {"The surface is empty"});
    TriangleMesh mesh = unit_box;
    mesh.vertices[5].y() = std::numeric_limits<double>::quiet_NaN();
    expectWords(sentenceFor(mesh), {"Vertex 5 ", "is not finite"});
    mesh = unit_box;
    mesh.triangles[7][1] = 8;
    EXPECT_EQ(
        sentenceFor(mesh),
        "Triangle 7 of the surface names vertex 8, but vertices are numbered 0 to 7; correct the number.");
    mesh.triangles[7][1] = -1;
    expectWords(sentenceFor(mesh), {"Triangle 7 ", "names vertex -1"});
}

TEST(SurfaceChecks, HolesAreNamed) {
    for (std::size_t t = 0; t < unit_box.triangles.size(); ++t) {
        TriangleMesh mesh = unit_box;
        mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(t));
        expectWords(sentenceFor(mesh),
                    {"The surface is open: the edge from (", "(3 such edges, at triangle"});
    }
}

TEST(SurfaceChecks, OneTurnedTriangleIsNamed) {
    TriangleMesh mesh = shapes::icosphere(1, 2);
    std::swap(mesh.triangles[17][0], mesh.triangles[17][1]);
    expectWords(sentenceFor(mesh), {"is not oriented", "17", "in the same direction"});
}

TEST(SurfaceChecks, EdgesOfFourTrianglesAreNamed) {
    // Two boxes with an edge in common.
    TriangleMesh mesh = shapes::joined(unit_box, shapes::translated(unit_box, Vec3(1, 1, 0)));
    const auto same = [&](int vertex) {
        for (int other = 0; other < vertex; ++other)
            if (mesh.vertices[other] == mesh.vertices[vertex]) return other;
        return vertex;
    };
    for (auto& triangle : mesh.triangles)
        for (int& corner : triangle) corner = same(corner);
    expectWords(sentenceFor(mesh), {"not a manifold", "(1, 1, 0) to (1, 1, 1)", "4 triangles"});
}

TEST(SurfaceChecks, PinchedPointsAreNamed) {
    TriangleMesh mesh = shapes::joined(unit_box, shapes::translated(unit_box, Vec3(1, 1, 1)));
    int shared[2] = {-1, -1};
    for (int v = 0; v < 16; ++v)
        if (mesh.vertices[v] == Vec3(1, 1, 1)) shared[v / 8] = v;
    for (auto& triangle : mesh.triangles)
        for (int& corner : triangle)
            if (corner == shared[1]) corner = shared[0];
    expectWords(sentenceFor(mesh), {"not a manifold", "single point (1, 1, 1)"});
}

TEST(SurfaceChecks, TrianglesWithoutAreaAreNamed) {
    TriangleMesh mesh = unit_box;
    // A vertex in the middle of the edge of triangle 0, which that triangle does not know of.
    const auto [a, b, c] = mesh.triangles[0];
    mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]) / 2);
    mesh.triangles.push_back({a, b, 8});
    expectWords(sentenceFor(mesh), {"Triangle 12 ", "has no area"});
}

TEST(SurfaceChecks, CrossingsAreNamedWithTheirPlace) {
    const TriangleMesh mesh =
        shapes::joined(shapes::icosphere(1, 3), shapes::translated(shapes::icosphere(0.1, 1), Vec3(0, 0, 1)));
    const std::string sentence = sentenceFor(mesh);
    expectWords(sentence, {"intersects itself: triangles "});
    double x = 9, y = 9, z = 9;
    ASSERT_EQ(std::sscanf(sentence.c_str() + sentence.find('('), "(%lf, %lf, %lf)", &x, &y, &z), 3)
        << sentence;
    EXPECT_LT((Vec3(x, y, z) - Vec3(0, 0, 1)).norm(), 0.15) << sentence;
}

TEST(SurfaceChecks, EveryFaultIsNamedWithItsCountAndFirstPlaces) {
    TriangleMesh mesh = shapes::inverted(shapes::icosphere(1, 2));
    mesh.triangles.erase(mesh.triangles.begin() + 100);
    mesh.triangles.erase(mesh.triangles.begin() + 30);
    std::swap(mesh.triangles[17][0], mesh.triangles[17][1]);
    mesh.triangles.push_back({0, 0, 1});
    const std::string sentence = sentenceFor(mesh);
    expectWords(sentence, {"has 5 kinds of faults: (1) ", "Triangle 318 ", "has no area", "is open",
                           "(6 such edges, at triangles ", "not a manifold", "not oriented",
                           "(3 such edges, at triangles ", "Most of the surface is inside out"});
    // The same by the faces of a file, which had two triangles each.
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) mesh.file_faces.push_back(1 + t / 2);
    expectWords(sentenceFor(mesh), {"Face 160 ", "at faces "});
}

TEST(SurfaceChecks, CrossingsOfOpenSurfacesAreNamedToo) {
    TriangleMesh mesh = shapes::joined(unit_box, shapes::translated(unit_box, Vec3(0.5, 0.5, 0.5)));
    mesh.triangles.pop_back();
    expectWords(sentenceFor(mesh), {"has 2 kinds of faults", "is open", "intersects itself"});
}

TEST(SurfaceChecks, SheetsWithoutVolumeAreNamed) {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.3}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 1}};
    expectWords(sentenceFor(mesh), {"encloses no volume"});
    expectWords(sentenceFor(shapes::joined(unit_box, shapes::translated(mesh, Vec3(3, 0, 0)))),
                {"encloses no volume", "(triangle 12)"});
}

TEST(SurfaceChecks, PartsThatFaceTheWrongWayAreNamed) {
    const TriangleMesh far = shapes::translated(unit_box, Vec3(3, 0, 0));
    EXPECT_EQ(sentenceFor(shapes::joined(unit_box, shapes::inverted(far))),
              "The part of the surface at (4, 0, 0) (triangle 12) is inside out; reverse the order of the "
              "corners in its faces.");
    expectWords(sentenceFor(shapes::joined(shapes::icosphere(1, 2), shapes::icosphere(0.5, 1))),
                {"(triangle 320) lies inside another part and faces outward"});
    expectWords(sentenceFor(shapes::inverted(shapes::hollowSphere(1, 0.5, 2))),
                {"The surface is inside out"});
    expectWords(sentenceFor(shapes::inverted(shapes::joined(unit_box, far))), {"The surface is inside out"});
}

TEST(SurfaceChecks, TheCupOfTheAssetsIsSound) {
    const Result<TriangleMesh> cup = readObj(std::string(SHERD_ASSETS) + "/coffee_cup.obj");
    ASSERT_TRUE(cup.ok()) << cup.error();
    EXPECT_EQ(sentenceFor(cup.value()), "");
    const TriangleMesh& mesh = cup.value();
    EXPECT_GE(mesh.triangles.size(), 10000u);
    EXPECT_LE(mesh.triangles.size(), 20000u);
    // One part with one handle: V - E + F = 0, with E = 3/2 F.
    EXPECT_EQ(2 * mesh.vertices.size(), mesh.triangles.size());
    Eigen::AlignedBox3d box;
    for (const Vec3& vertex : mesh.vertices) box.extend(vertex);
    EXPECT_EQ(box.min().z(), 0);
    EXPECT_NEAR(box.max().z(), 0.09, 1e-5);
    EXPECT_NEAR(box.sizes().y(), 0.08, 1e-5);
    EXPECT_NEAR(wallThickness(mesh), 0.005, 1e-4);
    for (const Vec3& vertex : mesh.vertices)  // nothing of the handle inside
        EXPECT_FALSE(std::hypot(vertex.x(), vertex.y()) < 0.0349 && vertex.z() > 0.0115 && vertex.z() < 0.087)
            << vertex.transpose();
}

TEST(WallThickness, IsThatOfTheThinnestWall) {
    EXPECT_NEAR(wallThickness(shapes::slab(Vec3(1, 1, 0.09))), 0.09, 1e-12);
    EXPECT_NEAR(wallThickness(
                    shapes::moved(shapes::slab(Vec3(1, 1, 0.09), 20, 20, 3), shapes::tilt(), Vec3(5, 0, 0))),
                0.09, 1e-12);
    EXPECT_NEAR(wallThickness(shapes::icosphere(0.1, 4)), 0.2, 0.002);
    EXPECT_NEAR(wallThickness(shapes::cup(0.04, 0.09, 0.005, 64, 16)), 0.005, 2e-4);
    EXPECT_NEAR(wallThickness(shapes::hollowSphere(1, 0.9, 4)), 0.1, 0.005);
}

}  // namespace
