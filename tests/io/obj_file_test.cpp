#include "io/obj_file.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

#include "geometry/mass_properties.h"
#include "geometry/merge_vertices.h"
#include "geometry/surface_checks.h"
#include "support/shapes.h"
#include "support/temporary_path.h"

namespace {

using namespace sherd;

std::string dataFile(const std::string& name) {
    return std::string(SHERD_TEST_DATA) + "/bad_obj/" + name;
}

TriangleMesh parsed(const std::string& text) {
    Result<TriangleMesh> mesh = parseObj(text, "text");
    EXPECT_TRUE(mesh.ok()) << mesh.error();
    return mesh.ok() ? mesh.value() : TriangleMesh{};
}

std::string faultIn(const std::string& text) {
    return parseObj(text, "cup.obj").error();
}

const std::string tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

TEST(ObjFile, ReadsEveryFormOfAFace) {
    const TriangleMesh plain = parsed(tetrahedron);
    ASSERT_EQ(plain.vertices.size(), 4u);
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvn 0 0 1\n";
    for (const std::string& faces :
         {std::string("f 1/1 3/1 2/1\nf 1/1/1 2/1/1 4/1/1\nf 2//1 3//1 4//1\nf 3 1 4\n"),
          std::string("f -4 -2 -3\r\nf -4 -3 -1\r\n# f 9 9 9\nf -3 -2 -1 # edge\n  f\t-2  -4 -1"),
          std::string("o cup\ng side\nusemtl white\ns 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4")})
        EXPECT_EQ(parsed(vertices + faces).triangles, plain.triangles) << faces;
}

/// An L of two legs, 1 thick, with caps of six corners that begin at another one each time.
std::string bracket(int first) {
    std::string text;
    for (const char* z : {"0", "1"})
        for (const char* xy : {"0 0", "3 0", "3 1", "1 1", "1 3", "0 3"})
            text += std::string("v ") + xy + " " + z + "\n";
    const auto cap = [&](int offset, int turn) {
        text += "f";
        for (int i = 0; i < 6; ++i) text += " " + std::to_string(offset + (first + turn * i + 36) % 6);
        text += "\n";
    };
    cap(1, -1);
    cap(7, 1);
    for (int i = 0; i < 6; ++i) {
        const int next = (i + 1) % 6;
        text += "f " + std::to_string(1 + i) + " " + std::to_string(1 + next) + " " +
                std::to_string(7 + next) + " " + std::to_string(7 + i) + "\n";
    }
    return text;
}

TEST(ObjFile, FacesThatAreNotConvexAreSplitInside) {
    for (int first = 0; first < 6; ++first) {
        const TriangleMesh mesh = parsed(bracket(first));
        EXPECT_EQ(mesh.triangles.size(), 2u * 4 + 6 * 2);
        EXPECT_TRUE(checkSurface(mesh)) << checkSurface(mesh).error();
        EXPECT_NEAR(solidMoments(mesh).volume, 5, 1e-12) << first;
    }
}

TEST(ObjFile, FacesThatFoldOverThemselvesAreReadAsTheyAre) {
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 2 2 0\n";
    EXPECT_EQ(parsed(corners + "f 1 2 3 4\n").triangles.size(), 2u);
    EXPECT_EQ(parsed(corners + "f 1 4 5 2 3\n").triangles.size(), 3u);
    EXPECT_EQ(parsed(corners + "f 1 2 1 3\n").triangles.size(), 2u);
}

TEST(ObjFile, ReadsNumbersInEveryNotation) {
    const TriangleMesh mesh = parsed("v +1.5 -.25 1e-3\nv 1E2 2. 3 0.5 0.5 0.5\nv 0 0 0\nf 1 2 3\n");
    EXPECT_EQ(mesh.vertices[0], Vec3(1.5, -0.25, 1e-3));
    EXPECT_EQ(mesh.vertices[1], Vec3(100, 2, 3));
}

TEST(ObjFile, SplitsPolygonsIntoFans) {
    const TriangleMesh mesh = parsed("v 0 0 0\nv 2 0 0\nv 3 1 0\nv 1 2 0\nv 0 1 0\nf 1 2 3 4 5\n");
    const std::vector<std::array<int, 3>> fan = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
    EXPECT_EQ(mesh.triangles, fan);
}

TEST(ObjFile, NamesTheLineThatIsWrong) {
    EXPECT_EQ(faultIn("v 0 0 0\nv 0 zero 0\n"),
              "cup.obj:2: the y coordinate 'zero' is not a number; a vertex is 'v x y z'.");
    EXPECT_EQ(faultIn("v 0 0\n"), "cup.obj:1: the z coordinate '' is not a number; a vertex is 'v x y z'.");
    EXPECT_EQ(faultIn("v 0 0 0\n\nv 0 0 -inf\n"),
              "cup.obj:3: the z coordinate '-inf' is not a finite number; correct this vertex.");
    EXPECT_EQ(faultIn("v 1e999 0 0\n"),
              "cup.obj:1: the x coordinate '1e999' is not a finite number; correct this vertex.");
    EXPECT_EQ(faultIn(tetrahedron + "f 1 2 5\n"),
              "cup.obj:9: the face names vertex 5, but 4 vertices precede it; correct the number.");
    EXPECT_EQ(faultIn(tetrahedron + "f 1 2 0\n"),
              "cup.obj:9: the face names vertex 0, but 4 vertices precede it; correct the number.");
    EXPECT_EQ(faultIn(tetrahedron + "f 1 2 -5\n"),
              "cup.obj:9: the face names vertex -5, but 4 vertices precede it; correct the number.");
    EXPECT_EQ(faultIn(tetrahedron + "f 1 2 99999999999999999999\n"),
              "cup.obj:9: the vertex number '99999999999999999999' is not a whole number.");
    EXPECT_EQ(faultIn(tetrahedron + "f 1 2.5 3\n"),
              "cup.obj:9: the vertex number '2.5' is not a whole number.");
    EXPECT_EQ(faultIn(tetrahedron + "f 1 2\n"), "cup.obj:9: a face has 2 corners; it needs 3 or more.");
}

TEST(ObjFile, AllFaultyLinesAreNamed) {
    EXPECT_EQ(
        faultIn(tetrahedron + "f 1 2 5\nf 1 2 3\nf 1 x\nv 0 0 nan\n"),
        "cup.obj:9: the face names vertex 5, but 4 vertices precede it; correct the number. 2 more lines "
        "are faulty: 11 and 12.");
}

TEST(ObjFile, RecordsGoOnAfterABackslash) {
    EXPECT_EQ(parsed("v 0 0 0\nv 1 0 \\\r\n0\nv 0 1 0\n# C:\\\nusemtl a\\b\nf 1 \\\n2\\\n 3\n").triangles,
              (std::vector<std::array<int, 3>>{{0, 1, 2}}));
    EXPECT_EQ(
        faultIn(tetrahedron + "f 1 \\\n2 \\\n5\nf 1 x\n"),
        "cup.obj:9: the face names vertex 5, but 4 vertices precede it; correct the number. 1 more line is "
        "faulty: 12.");
    EXPECT_EQ(faultIn(tetrahedron + "f 1 2 \\"), "cup.obj:9: the vertex number '\\' is not a whole number.");
}

TEST(ObjFile, TrianglesKnowTheirFacesInTheFile) {
    const TriangleMesh mesh =
        parsed("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nf 1 2 3 4\nf 1 1 2\nf 1 2 5\n");
    EXPECT_EQ(mesh.file_faces, (std::vector<int>{1, 1, 2, 3}));
}

TEST(ObjFile, IsScaledAndTurnedUpright) {
    const std::string path = temporaryPath("turned.obj");
    std::ofstream(path) << "v 0 0 0\nv 100 0 0\nv 0 200 0\nv 0 0 300\nvn 0 1 0\n"
                        << "f 1//1 3//1 2//1\nf 1//1 2//1 4//1\nf 1//1 4//1 3//1\nf 2//1 3//1 4//1\n";
    const Result<TriangleMesh> mesh = readObj(path, 0.01, UpAxis::y);
    EXPECT_NE(readObj(path, -1).error().find("scale"), std::string::npos);
    std::remove(path.c_str());
    ASSERT_TRUE(mesh.ok()) << mesh.error();
    EXPECT_LT((mesh.value().vertices[1] - Vec3(1, 0, 0)).norm(), 1e-12);
    EXPECT_LT((mesh.value().vertices[2] - Vec3(0, 0, 2)).norm(), 1e-12);
    EXPECT_LT((mesh.value().vertices[3] - Vec3(0, -3, 0)).norm(), 1e-12);
    EXPECT_EQ(mesh.value().normals[0][0], Vec3(0, 0, 1));
    EXPECT_EQ(mesh.value().file_faces, (std::vector<int>{1, 2, 3, 4}));
}

TEST(ObjFile, WhatIsNoPlainTextIsNamed) {
    const auto read = parseObj(std::string_view("v\0 \0", 4), "wide.obj");  // UTF-16
    ASSERT_FALSE(read.ok());
    EXPECT_NE(read.error().find("wide.obj: this is no plain text"), std::string::npos) << read.error();
}

TEST(ObjFile, FilesThatCannotBeReadSaySo) {
    EXPECT_EQ(readObj(dataFile("not_there.obj")).error(),
              dataFile("not_there.obj") + " cannot be opened; check that the file is there and may be read.");
    EXPECT_EQ(readObj(dataFile("empty.obj")).error(),
              dataFile("empty.obj") +
                  ": there are no faces in this file; export the surface of a solid as polygons ('v' and 'f' "
                  "records).");
    EXPECT_EQ(
        readObj(dataFile("nan.obj")).error(),
        dataFile("nan.obj") + ":4: the y coordinate 'nan' is not a finite number; correct this vertex.");
    EXPECT_EQ(readObj(SHERD_TEST_DATA).error(), SHERD_TEST_DATA " is a folder; name an OBJ file in it.");
    EXPECT_NE(writeObj(parsed(tetrahedron), dataFile("no/such/folder.obj"))
                  .error()
                  .find("cannot be opened for writing"),
              std::string::npos);
}

TEST(ObjFile, WhatIsWrittenReadsBackBitByBit) {
    TriangleMesh mesh = shapes::moved(shapes::icosphere(1.0 / 3, 2), shapes::tilt(), Vec3(1e5, -1e-7, 0.1));
    mesh.vertices[0].x() = 0x1.fffffffffffffp-3;
    mesh.kinds.assign(mesh.triangles.size(), SurfaceKind::original);
    for (const std::size_t crack : {0, 1, 7, 100}) mesh.kinds[crack] = SurfaceKind::crack;
    const std::string path = temporaryPath("round_trip.obj");
    ASSERT_TRUE(writeObj(mesh, path).ok());
    const Result<TriangleMesh> back = readObj(path);
    std::remove(path.c_str());
    ASSERT_TRUE(back.ok()) << back.error();
    EXPECT_EQ(back.value().vertices, mesh.vertices);
    EXPECT_EQ(back.value().triangles, mesh.triangles);
    EXPECT_EQ(back.value().kinds, mesh.kinds);
}

TEST(ObjFile, EqualPositionsBecomeOneVertex) {
    // A tetrahedron exported face by face, with a vertex that nobody uses and a triangle that shrinks to an
    // edge.
    const TriangleMesh solid = parsed(tetrahedron);
    TriangleMesh soup;
    soup.vertices.emplace_back(7, 7, 7);
    for (const auto& triangle : solid.triangles) {
        const int first = static_cast<int>(soup.vertices.size());
        for (const int corner : triangle) soup.vertices.push_back(solid.vertices[corner]);
        soup.triangles.push_back({first, first + 1, first + 2});
        soup.kinds.push_back(SurfaceKind::original);
    }
    soup.vertices[1].x() = -0.0;  // equal to 0 all the same
    soup.triangles.insert(soup.triangles.begin(), {1, 4, 2});
    soup.kinds.insert(soup.kinds.begin(), SurfaceKind::crack);
    const TriangleMesh merged = mergeEqualVertices(soup);
    EXPECT_EQ(merged.vertices.size(), 4u);
    EXPECT_EQ(merged.triangles.size(), 4u);
    EXPECT_EQ(merged.kinds, std::vector<SurfaceKind>(4, SurfaceKind::original));
    for (std::size_t t = 0; t < 4; ++t)
        for (int k = 0; k < 3; ++k)
            EXPECT_EQ(merged.vertices[merged.triangles[t][k]], solid.vertices[solid.triangles[t][k]]);
}

}  // namespace
