#include <limits>

#include "geometry/repair/support.h"

namespace {

using namespace sherd;
using namespace sherd::repair_tests;

TEST(Repair, TrianglesThatStayKeepTheirLook) {
    TriangleMesh mesh = shapes::icosphere(1, 2);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const double s = static_cast<double>(t);
        mesh.texture_coordinates.push_back({Vec2(s, 1), Vec2(s, 2), Vec2(s, 3)});
    }
    const TriangleMesh before = mesh;
    mesh.triangles.pop_back();
    mesh.texture_coordinates.pop_back();
    const TriangleMesh result = repaired(mesh).mesh;
    ASSERT_EQ(result.texture_coordinates.size(), before.triangles.size());
    std::size_t kept = 0;
    for (std::size_t t = 0; t < result.triangles.size(); ++t)
        for (std::size_t s = 0; s < mesh.triangles.size(); ++s) {
            int k = 0;
            while (k < 3 &&
                   result.vertices[result.triangles[t][k]] != before.vertices[before.triangles[s][0]])
                ++k;
            if (k == 3) continue;
            bool same = true;
            for (int i = 0; i < 3; ++i)
                same = same && result.vertices[result.triangles[t][(k + i) % 3]] ==
                                   before.vertices[before.triangles[s][i]];
            if (!same) continue;
            ++kept;
            for (int i = 0; i < 3; ++i)
                EXPECT_EQ(result.texture_coordinates[t][(k + i) % 3], before.texture_coordinates[s][i]);
        }
    EXPECT_EQ(kept, mesh.triangles.size());
}

TEST(Repair, ScalesAndTurns) {
    Repair repair;
    repair.scale = 0.001;
    repair.up_axis = UpAxis::y;
    const RepairedMesh y_up = repaired(shapes::box(Vec3(0, 0, 0), Vec3(100, 200, 400)), repair);
    Eigen::AlignedBox3d box;
    for (const Vec3& v : y_up.mesh.vertices) box.extend(v);
    EXPECT_LT((box.sizes() - Vec3(0.1, 0.4, 0.2)).norm(), 1e-12);
    EXPECT_EQ(box.min().z(), 0);
    repair.up_axis = UpAxis::x;
    const RepairedMesh x_up = repaired(shapes::box(Vec3(0, 0, 0), Vec3(100, 200, 400)), repair);
    box.setEmpty();
    for (const Vec3& v : x_up.mesh.vertices) box.extend(v);
    EXPECT_LT((box.sizes() - Vec3(0.4, 0.2, 0.1)).norm(), 1e-12);
    EXPECT_EQ(box.min().z(), 0);
}

TEST(Repair, SizesThatAreHardlyMeantAreNamed) {
    EXPECT_EQ(sizeWarning(unit_box), "");
    EXPECT_NE(sizeWarning(shapes::slab(Vec3(30, 10, 10))).find("30 m long"), std::string::npos);
    EXPECT_NE(sizeWarning(shapes::slab(Vec3(0.003, 0.001, 0.001))).find("0.003 m long"), std::string::npos);
}

TEST(Repair, SentencesAreSaidInAProgramsOwnNames) {
    const std::string sentence = "Raise Repair::scale, or Repair::scale and a.";
    EXPECT_EQ(withNames(sentence, {{"Repair::scale", "--scale"}, {"b", "c"}}),
              "Raise --scale, or --scale and a.");
    EXPECT_EQ(withNames(sentence, {}), sentence);
}

TEST(Repair, WhatIsNoMeshHasItsSentence) {
    const auto sentence = [](const TriangleMesh& mesh) {
        return repairMesh(mesh, Repair::automatic()).error();
    };
    EXPECT_NE(sentence({}).find("is empty"), std::string::npos);
    TriangleMesh mesh = unit_box;
    mesh.vertices[3].z() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(sentence(mesh).find("not finite"), std::string::npos);
    mesh.vertices[3].z() = 1e300;
    EXPECT_NE(sentence(mesh).find("1e9 m"), std::string::npos);
    mesh = unit_box;
    mesh.triangles[2][1] = 99;
    EXPECT_NE(sentence(mesh).find("names vertex 99"), std::string::npos);
    mesh = unit_box;
    mesh.normals.resize(3, {Vec3::UnitX(), Vec3::UnitX(), Vec3::UnitX()});
    EXPECT_NE(sentence(mesh).find("3 entries in normals"), std::string::npos);
    mesh = unit_box;
    for (Vec3& v : mesh.vertices) v = Vec3(v.x(), 0, 0);
    EXPECT_NE(sentence(mesh).find("has an area"), std::string::npos) << sentence(mesh);
    Repair repair;
    repair.scale = 0;
    EXPECT_NE(repairMesh(unit_box, repair).error().find("scale"), std::string::npos);
    repair = Repair::automatic();
    repair.wrap_detail = 1;
    EXPECT_NE(repairMesh(unit_box, repair).error().find("wrap_detail"), std::string::npos);
}

}  // namespace
