#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "geometry/repair/support.h"

namespace {

using namespace sherd;
using namespace sherd::repair_tests;

TriangleMesh sheet() {
    TriangleMesh mesh;
    for (int j = 0; j <= 10; ++j)
        for (int i = 0; i <= 10; ++i) mesh.vertices.emplace_back(i * 0.1, j * 0.1, 0.1 * std::sin(0.3 * i));
    for (int j = 0; j < 10; ++j)
        for (int i = 0; i < 10; ++i) {
            const int a = 11 * j + i;
            mesh.triangles.push_back({a, a + 1, a + 12});
            mesh.triangles.push_back({a, a + 12, a + 11});
        }
    return mesh;
}

TEST(Repair, WrapsWhatCannotBeMended) {
    EXPECT_FALSE(repairMesh(sheet(), mendOnly()).ok());
    const RepairedMesh result = repaired(sheet(), Repair::automatic());
    EXPECT_TRUE(result.report.wrapped);
    EXPECT_LT(result.report.largest_distance_m, 0.01 * result.report.size_m);
    EXPECT_GT(result.report.largest_distance_m, 0.002 * result.report.size_m) << "the walls around a sheet";
    EXPECT_GT(volumeOf(result.mesh), 0.005);
    Repair always = Repair::automatic();
    always.mode = Repair::Mode::wrap;
    const RepairedMesh ball = repaired(shapes::icosphere(1, 3), always);
    EXPECT_TRUE(ball.report.wrapped);
    EXPECT_LT(ball.report.largest_distance_m, 0.01 * ball.report.size_m);
    EXPECT_NEAR(volumeOf(ball.mesh), 4 * pi / 3, 0.15);
}

TEST(Repair, TheWrapOfWhatFoldsIntoSheetsHasNoThinWalls) {
    // A prism whose profile crosses itself: between the two halves its caps are sheets.
    TriangleMesh mesh;
    for (const double z : {0.0, 0.1})
        for (const Vec2& p : {Vec2(0, 0), Vec2(0.2, 0.2), Vec2(0.2, 0), Vec2(0, 0.2)})
            mesh.vertices.emplace_back(p.x(), p.y(), z);
    mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}};
    for (int k = 0; k < 4; ++k) {
        const int next = (k + 1) % 4;
        mesh.triangles.push_back({k, next, next + 4});
        mesh.triangles.push_back({k, next + 4, k + 4});
    }
    Repair coarse = Repair::automatic();
    coarse.wrap_detail *= 2;
    const RepairedMesh result = repaired(mesh, coarse);
    ASSERT_TRUE(result.report.wrapped);
    EXPECT_GT(wallThickness(result.mesh), 0.9 * coarse.wrap_detail * result.report.size_m);
}

TEST(Repair, TheWrapCarriesTheLookOfTheOriginal) {
    // A box whose sides have a material, a colour, a normal and texture coordinates each, by their place.
    TriangleMesh mesh = shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 1), 4, 4, 4);
    mesh.materials = {"below", "above"};
    for (const Vec3& v : mesh.vertices) mesh.colours.push_back(v);
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3 &x = mesh.vertices[a], &y = mesh.vertices[b], &z = mesh.vertices[c];
        const Vec3 normal = (y - x).cross(z - x).normalized();
        mesh.normals.push_back({normal, normal, normal});
        mesh.material.push_back((x + y + z).z() / 3 > 0.5);
        const bool upper = normal.z() > 0.5;  // another chart on the lid
        const auto uv = [&](const Vec3& p) { return Vec2(p.x() + (upper ? 10 : 0), p.y()); };
        mesh.texture_coordinates.push_back({uv(x), uv(y), uv(z)});
    }
    Repair wrap = Repair::automatic();
    wrap.mode = Repair::Mode::wrap;
    wrap.wrap_detail = 0.03;
    const TriangleMesh result = repaired(mesh, wrap).mesh;
    ASSERT_EQ(result.colours.size(), result.vertices.size());
    for (std::size_t v = 0; v < result.vertices.size(); ++v)
        EXPECT_LT((result.colours[v] - result.vertices[v]).norm(), 0.05);
    for (std::size_t t = 0; t < result.triangles.size(); ++t) {
        Vec3 middle = Vec3::Zero();
        for (const int corner : result.triangles[t]) middle += result.vertices[corner] / 3;
        if (std::abs(middle.z() - 0.5) > 0.1) {
            EXPECT_EQ(result.material[t], middle.z() > 0.5);
        }
        const double offset = middle.z() > 1 ? 10 : 0;
        const bool on_seam = middle.z() > 0.95 && middle.z() < 1.01;
        for (int k = 0; k < 3; ++k) {
            const Vec3& x = result.vertices[result.triangles[t][k]];
            EXPECT_NEAR(result.normals[t][k].norm(), 1, 1e-12);
            if (on_seam) continue;
            EXPECT_NEAR(result.texture_coordinates[t][k].x(), x.x() + offset, 0.1) << x.transpose();
            EXPECT_NEAR(result.texture_coordinates[t][k].y(), x.y(), 0.1);
        }
    }
}

TEST(Repair, ShellThicknessMakesASolidHollow) {
    Repair hollow;
    hollow.shell_thickness_m = 0.1;
    TriangleMesh solid = shapes::icosphere(1, 4);
    for (std::size_t t = 0; t < solid.triangles.size(); ++t)
        solid.file_faces.push_back(static_cast<int>(t) + 1);
    const RepairedMesh ball = repaired(solid, hollow);
    EXPECT_TRUE(ball.report.hollowed);
    const double shell = 4 * pi / 3 * (1 - 0.729);
    EXPECT_NEAR(volumeOf(ball.mesh), shell, 0.06 * shell);
    EXPECT_NEAR(wallThickness(ball.mesh), 0.1, 0.01);
    hollow.shell_thickness_m = 2;
    EXPECT_NE(repairMesh(shapes::icosphere(1, 3), hollow).error().find("leaves no cavity"),
              std::string::npos);
}

/// A ball of radius 1 without its cap above z = 0.7, and without a triangle elsewhere.
TriangleMesh bowl() {
    TriangleMesh mesh = shapes::icosphere(1, 4);
    auto& all = mesh.triangles;
    all.erase(std::remove_if(all.begin(), all.end(),
                             [&](const auto& t) {
                                 const Vec3 middle =
                                     (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3;
                                 return middle.z() > 0.7;
                             }),
              all.end());
    all.erase(all.begin() + 100);
    return mesh;
}

TEST(Repair, ShellThicknessMakesWallsOfAVesselAndLeavesItOpen) {
    constexpr double thickness = 0.05;
    const double walls = 2 * pi * 1.7 * (1 - std::pow(1 - thickness, 3)) / 3;  // a cone out of the middle
    for (const Repair::Mode mode : {Repair::Mode::mend, Repair::Mode::automatic, Repair::Mode::wrap}) {
        Repair thick;
        thick.mode = mode;
        thick.shell_thickness_m = thickness;
        for (const bool inward : {false, true}) {
            const RepairedMesh vessel = repaired(inward ? shapes::inverted(bowl()) : bowl(), thick);
            EXPECT_TRUE(vessel.report.thickened);
            EXPECT_FALSE(vessel.report.hollowed);
            EXPECT_EQ(vessel.report.wrapped, mode == Repair::Mode::wrap);
            EXPECT_EQ(vessel.report.filled_holes, 1) << "the small one";
            EXPECT_NEAR(volumeOf(vessel.mesh), walls, 0.1 * walls) << "with a lid it is a fifth more";
            EXPECT_NEAR(wallThickness(vessel.mesh), thickness, 0.15 * thickness);
            const double radius = (boundingBox(vessel.mesh).sizes().x()) / 2;
            EXPECT_NEAR(radius, vessel.report.wrapped ? 1 + thickness / 2 : 1, 0.3 * thickness);
        }
    }
}

TEST(Repair, WallsAreAsThickAtEdgesAndCorners) {
    TriangleMesh box = shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    auto& all = box.triangles;  // without a lid
    const auto is_lid = [&](const auto& t) {
        return std::all_of(t.begin(), t.end(), [&](int v) { return box.vertices[v].z() == 1; });
    };
    all.erase(std::remove_if(all.begin(), all.end(), is_lid), all.end());
    Repair thick = mendOnly();
    thick.shell_thickness_m = 0.1;
    EXPECT_NEAR(volumeOf(repaired(box, thick).mesh), 1 - 0.8 * 0.8 * 0.9, 0.01);
    thick.shell_thickness_m = 1e-5;
    EXPECT_NE(repairMesh(box, thick).error().find("in m, after scaling"), std::string::npos);
}

TEST(Repair, PartsThatAreNotSewnTogetherEncloseASolidThatBecomesHollow) {
    TriangleMesh mesh;  // the faces of a box, each by itself and a little apart
    const TriangleMesh box = shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {0.0, 1.0}) {
            TriangleMesh face;
            for (const auto& t : box.triangles)
                if (std::all_of(t.begin(), t.end(), [&](int v) { return box.vertices[v][axis] == side; }))
                    face.triangles.push_back(t);
            for (const Vec3& v : box.vertices) {
                Vec3 place = v;
                place[axis] += side == 1.0 ? 0.02 : -0.02;
                face.vertices.push_back(place);
            }
            mesh = shapes::joined(mesh, face);
        }
    Repair thick = Repair::automatic();
    thick.wrap_detail = 0.04;
    thick.shell_thickness_m = 0.05;
    const RepairedMesh result = repaired(mesh, thick);
    EXPECT_TRUE(result.report.hollowed);
    EXPECT_LT(volumeOf(result.mesh), 0.5) << "not filled up, and called walls";
}

TEST(Repair, AThicknessWithoutAModeSaysThatNothingIsMended) {
    Repair off;
    off.shell_thickness_m = 0.05;
    const auto refused = repairMesh(bowl(), off);
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().find("mends nothing by itself"), std::string::npos) << refused.error();
}

TEST(Repair, WallsThatWouldCrossAreWrapped) {
    const TriangleMesh two = shapes::joined(bowl(), shapes::translated(bowl(), Vec3(1.5, 0, 0)));
    Repair thick = Repair::automatic();
    thick.shell_thickness_m = 0.1;
    const RepairedMesh vessel = repaired(two, thick);
    EXPECT_TRUE(vessel.report.thickened && vessel.report.wrapped);
    EXPECT_LT(volumeOf(vessel.mesh), 1.2 * 2 * 2 * pi * 1.7 * 0.1)
        << "two full balls have four times as much";
}

TEST(Repair, GivesTheSameBitsEachTime) {
    Repair coarse = Repair::automatic();
    coarse.wrap_detail = 0.02;
    const RepairedMesh first = repaired(sheet(), coarse);
    std::mt19937 random(1);
    std::vector<std::unique_ptr<char[]>> others;  // so that the next one lies elsewhere in memory
    for (int i = 0; i < 20000; ++i) {
        others.push_back(std::make_unique<char[]>(16 + random() % 1000));
        if (random() % 2) others[random() % others.size()] = nullptr;
    }
    const RepairedMesh second = repaired(sheet(), coarse);
    ASSERT_TRUE(first.report.wrapped);
    EXPECT_EQ(first.mesh.vertices, second.mesh.vertices);
    EXPECT_EQ(first.mesh.triangles, second.mesh.triangles);
}

}  // namespace
