// Meshes of several formats are the same surface; what is none is refused with a sentence.
#include "viewer/mesh_import.h"

#include <gtest/gtest.h>

#include <fstream>

#include "scenes/box_mesh.h"
#include "support/temporary_path.h"
#include "viewer/own_mesh.h"

namespace {

using demo::importMesh;

sherd::TriangleMesh box() {
    return demo::boxMesh({demo::Vec3(0.2, 0.1, 0.1), 0.1});
}

std::string writeOff(const sherd::TriangleMesh& mesh, const std::string& name) {
    const std::string path = temporaryPath(name);
    std::ofstream out(path);
    out << "OFF\n" << mesh.vertices.size() << " " << mesh.triangles.size() << " 0\n";
    for (const auto& v : mesh.vertices) out << v.x() << " " << v.y() << " " << v.z() << "\n";
    for (const auto& t : mesh.triangles) out << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
    return path;
}

std::string writeStl(const sherd::TriangleMesh& mesh, const std::string& name) {
    const std::string path = temporaryPath(name);
    std::ofstream out(path);
    out << "solid box\n";
    for (const auto& t : mesh.triangles) {
        out << "facet normal 0 0 0\nouter loop\n";
        for (int v : t)
            out << "vertex " << mesh.vertices[v].x() << " " << mesh.vertices[v].y() << " "
                << mesh.vertices[v].z() << "\n";
        out << "endloop\nendfacet\n";
    }
    out << "endsolid box\n";
    return path;
}

TEST(MeshImport, VerticesOfTriangleSoupAreJoined) {
    const auto mesh = importMesh(writeStl(box(), "box.stl"));
    ASSERT_TRUE(mesh.ok()) << mesh.error();
    EXPECT_EQ(mesh.value().vertices.size(), box().vertices.size());
    EXPECT_EQ(mesh.value().triangles.size(), box().triangles.size());
}

TEST(MeshImport, AFileThatIsMissingOrNoMeshIsRefusedWithItsName) {
    EXPECT_NE(importMesh("nowhere.stl").error().find("There is no file nowhere.stl"), std::string::npos);
    const std::string path = temporaryPath("text.ply");
    std::ofstream(path) << "no mesh at all\n";
    EXPECT_NE(importMesh(path).error().find("text.ply cannot be read: "), std::string::npos);
}

TEST(MeshImport, TriangleStripsAreRefusedBeforeTheyAreLost) {
    const std::string path = temporaryPath("strips.ply");
    std::ofstream(path) << "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                           "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n"
                           "end_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n6 0 1 2 3 0 1\n";
    EXPECT_NE(importMesh(path).error().find("strips.ply keeps its triangles in strips"), std::string::npos);
}

TEST(OwnMesh, IsScaledToTheSizeThatIsAskedFor) {
    demo::Choices choices;
    choices.file = writeOff(box(), "box.off");
    choices.own_mesh.material = "glass";
    choices.own_mesh.size_m = 0.5;
    const auto loaded = demo::load(choices, "");
    ASSERT_TRUE(loaded.ok()) << loaded.error();
    ASSERT_EQ(loaded.value().assets.bodies.size(), 1u);
    const sherd::BreakableAsset& asset = loaded.value().assets.bodies.front();
    EXPECT_EQ(asset.material().name, "glass");
    EXPECT_NEAR(asset.volume(), 0.5 * 0.25 * 0.25, 1e-6);
}

TEST(OwnMesh, AnOpenSurfaceIsRefusedUnlessItIsToBeRepaired) {
    sherd::TriangleMesh open = box();
    open.triangles.pop_back();
    demo::Choices choices;
    choices.file = writeOff(open, "open.off");
    const auto refused = demo::load(choices, "");
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().find("The surface is open"), std::string::npos) << refused.error();
    EXPECT_NE(refused.error().find(" --repair mends such meshes"), std::string::npos) << refused.error();
    EXPECT_EQ(refused.error().find("Repair::"), std::string::npos) << refused.error();
    choices.own_mesh.repair = true;
    const auto mended = demo::load(choices, "");
    ASSERT_TRUE(mended.ok()) << mended.error();
    EXPECT_FALSE(mended.value().said.empty());
    for (const std::string& sentence : mended.value().said)
        EXPECT_EQ(sentence.find("Repair::"), std::string::npos) << sentence;
}

}  // namespace
