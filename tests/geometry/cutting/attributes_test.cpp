// What a renderer wants to know about a mesh, from the file through two breaks and back into a file.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>

#include "geometry/cutting/cut_checks.h"
#include "geometry/cutting/cut_fragments.h"
#include "geometry/cutting/fragment_support.h"
#include "geometry/merge_vertices.h"
#include "io/obj_file.h"
#include "support/shapes.h"
#include "support/temporary_path.h"

namespace sherd {
namespace {

using namespace fragment_support;

// Values that interpolation must give back exactly, but for rounding: they are linear in the position.
Vec2 textureAt(const Vec3& x) {
    return {3 * x.x() - x.y() + 0.3, x.z() + 2 * x.y()};
}

Vec3 colourAt(const Vec3& x) {
    return (x.array() * 0.4 + 0.5).matrix();
}

// Texture coordinates with a seam (every triangle is moved by its number), a material for each half.
TriangleMesh decorated(TriangleMesh mesh) {
    mesh.materials = {"clay", "glaze"};
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const Vec3 &p = mesh.vertices[a], &q = mesh.vertices[b], &r = mesh.vertices[c];
        const Vec2 island(static_cast<double>(t), 0);
        mesh.texture_coordinates.push_back(
            {textureAt(p) + island, textureAt(q) + island, textureAt(r) + island});
        const Vec3 normal = (q - p).cross(r - p).normalized();
        mesh.normals.push_back({normal, normal, (normal + Vec3(0.1, 0.2, 0.3)).normalized()});
        mesh.material.push_back(p.x() + q.x() + r.x() > 0);
    }
    for (const Vec3& v : mesh.vertices) mesh.colours.push_back(colourAt(v));
    return mesh;
}

TriangleMesh plate() {
    return decorated(shapes::slab({1, 1, 0.09}, 12, 12, 2));
}

FragmentSurfaces cut(const TriangleMesh& mesh, double spacing, int count) {
    const Discretisation solid = particlesOnly(mesh, spacing);
    auto result = cutFragments(mesh, solid, randomClusters(solid, count, 3), {3});
    EXPECT_TRUE(result) << result.error();
    return result ? std::move(result).value() : FragmentSurfaces();
}

void expectEqualAttributes(const TriangleMesh& a, const TriangleMesh& b) {
    EXPECT_EQ(a.texture_coordinates, b.texture_coordinates);
    EXPECT_EQ(a.normals, b.normals);
    EXPECT_EQ(a.material, b.material);
    EXPECT_EQ(a.materials, b.materials);
    EXPECT_EQ(a.colours, b.colours);
}

TEST(Attributes, AreWrittenAndReadBackBitByBit) {
    TriangleMesh mesh = plate();
    mesh.kinds.assign(mesh.triangles.size(), SurfaceKind::original);
    mesh.kinds[5] = SurfaceKind::crack;
    const std::string path = temporaryPath("mesh.obj");
    for (int dropped = 0; dropped < 5; ++dropped) {
        if (dropped == 1) mesh.normals.clear();
        if (dropped == 2) mesh.texture_coordinates.clear();
        if (dropped == 3) mesh.colours.clear(), mesh.normals = plate().normals;
        if (dropped == 4) mesh.material.clear(), mesh.materials.clear();
        ASSERT_TRUE(writeObj(mesh, path).ok());
        const Result<TriangleMesh> back = readObj(path);
        std::remove(path.c_str());
        ASSERT_TRUE(back.ok()) << back.error();
        EXPECT_EQ(back.value().vertices, mesh.vertices);
        EXPECT_EQ(back.value().triangles, mesh.triangles);
        EXPECT_EQ(back.value().kinds, mesh.kinds);
        expectEqualAttributes(back.value(), mesh);
    }
}

TEST(Attributes, StayWithTheirCornersWhenVerticesAreMerged) {
    const TriangleMesh mesh = plate();
    TriangleMesh soup = mesh;
    soup.vertices.clear(), soup.triangles.clear(), soup.colours.clear();
    for (const auto& triangle : mesh.triangles) {
        const int first = static_cast<int>(soup.vertices.size());
        for (const int v : triangle) {
            soup.vertices.push_back(mesh.vertices[v]);
            soup.colours.emplace_back(v % 2 ? Vec3(0, 0.5, 1) : Vec3(1, 0, 0.25));
        }
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    soup.colours[0] += Vec3(0, 0.5, 0);  // one of several at a position
    const TriangleMesh merged = mergeEqualVertices(soup);
    EXPECT_EQ(merged.vertices.size(), mesh.vertices.size());
    EXPECT_EQ(merged.texture_coordinates, mesh.texture_coordinates);
    EXPECT_EQ(merged.normals, mesh.normals);
    EXPECT_EQ(merged.material, mesh.material);
    ASSERT_EQ(merged.colours.size(), merged.vertices.size());
    const int first = mesh.triangles[0][0];
    int meeting = 0;
    for (const auto& t : mesh.triangles) meeting += std::count(t.begin(), t.end(), first);
    EXPECT_NEAR(merged.colours[0].y(), (first % 2 ? 0.5 : 0.0) + 0.5 / meeting, 1e-15);
    EXPECT_EQ(merged.colours[1], mesh.triangles[0][1] % 2 ? Vec3(0, 0.5, 1) : Vec3(1, 0, 0.25));
}

TEST(Attributes, OfAFileThatHasThemInPartsAreFilledUp) {
    const auto mesh = parseObj(
        "v 0 0 0 0.1 0.2 0.3\nv 1 0 0\nv 0 1 0 1 0 1\nv 0 0 1 1\nvt 0.5\nvt 0.25 0.75 0\nvn 0 0 -1\n"
        "f 1/1/1 3/-1/1 2//1\nusemtl red clay\nf 1 2 4\n",
        "text");
    ASSERT_TRUE(mesh) << mesh.error();
    const TriangleMesh& m = mesh.value();
    const std::vector<Vec3> colours = {{0.1, 0.2, 0.3}, {1, 1, 1}, {1, 0, 1}, {1, 1, 1}};
    EXPECT_EQ(m.colours, colours);
    EXPECT_EQ(m.texture_coordinates[0], (std::array<Vec2, 3>{Vec2(0.5, 0), Vec2(0.25, 0.75), Vec2(0, 0)}));
    EXPECT_EQ(m.texture_coordinates[1], (std::array<Vec2, 3>{Vec2(0, 0), Vec2(0, 0), Vec2(0, 0)}));
    EXPECT_EQ(m.normals[0][2], -Vec3::UnitZ());
    EXPECT_EQ(m.normals[1][2], Vec3::Zero());
    EXPECT_EQ(m.materials, (std::vector<std::string>{"original", "red clay"}));
    EXPECT_EQ(m.material, (std::vector<int>{0, 1}));
}

TEST(Attributes, ThatAreWrongAreNamed) {
    const auto fault = [](const std::string& text) { return parseObj(text, "cup.obj").error(); };
    EXPECT_EQ(
        fault("v 0 0 0 1 0 x\n"),
        "cup.obj:1: the blue component 'x' is not a number; a vertex with a colour is 'v x y z r g b'.");
    EXPECT_EQ(
        fault("v 0 0 0 0 255 0\n"),
        "cup.obj:1: the green component of a colour is not between 0 and 1; divide colours by their largest "
        "value.");
    EXPECT_EQ(fault("vt a 0\n"),
              "cup.obj:1: the u coordinate 'a' is not a number; texture coordinates are 'vt u v'.");
    EXPECT_EQ(fault("vn 0 0 inf\n"),
              "cup.obj:1: the z component 'inf' is not a finite number; correct this normal.");
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n";
    EXPECT_EQ(
        fault(vertices + "f 1/1 2/2 3/1\n"),
        "cup.obj:5: the face names texture coordinate 2, but 1 texture coordinates precede it; correct the "
        "number.");
    EXPECT_EQ(fault(vertices + "f 1//1 2 3\n"),
              "cup.obj:5: the face names normal 1, but 0 normals precede it; correct the number.");
    EXPECT_EQ(fault(vertices + "f 1/x 2 3\n"),
              "cup.obj:5: the texture coordinate number '1/x' is not a whole number.");
}

// Kept triangles bit for bit, parts of crossed ones as at their place.
void expectInherited(const TriangleMesh& body, const FragmentSurface& piece, int& kept, int& parts) {
    const TriangleMesh& mesh = piece.mesh;
    ASSERT_EQ(mesh.texture_coordinates.size(), mesh.triangles.size());
    ASSERT_EQ(mesh.normals.size(), mesh.triangles.size());
    ASSERT_EQ(mesh.material.size(), mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const int parent = piece.parents[t];
        if (parent < 0) continue;
        EXPECT_EQ(mesh.materials[mesh.material[t]], body.materials[body.material[parent]]);
        const auto at = [&](int i) { return mesh.vertices[mesh.triangles[t][i]]; };
        const auto corner = [&](int i) { return body.vertices[body.triangles[parent][i]]; };
        if (at(0) == corner(0) && at(1) == corner(1) && at(2) == corner(2)) {
            EXPECT_EQ(mesh.texture_coordinates[t], body.texture_coordinates[parent]);
            EXPECT_EQ(mesh.normals[t], body.normals[parent]);
            ++kept;
            continue;
        }
        ++parts;
        Mat3 corners;
        corners << corner(0), corner(1), corner(2);
        for (int i = 0; i < 3; ++i) {
            const Vec3 w =
                (corners.colwise() + Vec3(5, 6, 7)).colPivHouseholderQr().solve(at(i) + Vec3(5, 6, 7));
            Vec2 texture = Vec2::Zero();
            Vec3 normal = Vec3::Zero();
            for (int k = 0; k < 3; ++k) {
                texture += w[k] * body.texture_coordinates[parent][k];
                normal += w[k] * body.normals[parent][k];
            }
            EXPECT_LT((mesh.texture_coordinates[t][i] - texture).norm(), 1e-8);
            EXPECT_LT((mesh.normals[t][i] - normal.normalized()).norm(), 1e-8);
        }
    }
}

// Crack coordinates measure lengths: they show no triangle smaller than 0.3 of its area, most areas nearly
// whole, and are shared along edges but for places where the crack turns.
void expectUsableCracks(const FragmentSurface& piece) {
    const TriangleMesh& mesh = piece.mesh;
    std::map<std::pair<int, int>, std::array<Vec2, 2>> across_edge;
    int shared = 0, torn = 0;
    double whole_area = 0, seen_area = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (piece.parents[t] >= 0) continue;
        EXPECT_EQ(mesh.materials[mesh.material[t]], "crack");
        const auto& uv = mesh.texture_coordinates[t];
        const Vec3 &a = mesh.vertices[mesh.triangles[t][0]], &b = mesh.vertices[mesh.triangles[t][1]],
                   &c = mesh.vertices[mesh.triangles[t][2]];
        const Vec2 p = uv[1] - uv[0], q = uv[2] - uv[0];
        const double area = (b - a).cross(c - a).norm(), seen = std::abs(p.x() * q.y() - p.y() * q.x());
        whole_area += area, seen_area += seen;
        EXPECT_LE(seen, area * (1 + 1e-9));
        EXPECT_GE(seen, 0.29 * area);
        EXPECT_NEAR(mesh.normals[t][0].dot((b - a).cross(c - a)), area, 1e-9 * area);
        for (int i = 0; i < 3; ++i) {
            const int from = mesh.triangles[t][i], to = mesh.triangles[t][(i + 1) % 3];
            across_edge[{from, to}] = {uv[i], uv[(i + 1) % 3]};
            const auto other = across_edge.find({to, from});
            if (other == across_edge.end()) continue;
            (other->second[0] == uv[(i + 1) % 3] && other->second[1] == uv[i] ? shared : torn) += 1;
        }
    }
    EXPECT_LT(torn, 0.2 * shared);
    EXPECT_GT(seen_area, 0.75 * whole_area);
}

TEST(Attributes, GoThroughTwoBreaks) {
    const TriangleMesh body = plate();
    int kept = 0, parts = 0, cracks_again = 0;
    for (const FragmentSurface& piece : cut(body, 1 / 22.0, 8).pieces) {
        expectInherited(body, piece, kept, parts);
        expectUsableCracks(piece);
        EXPECT_EQ(piece.mesh.materials, (std::vector<std::string>{"clay", "glaze", "crack"}));
        for (std::size_t v = 0; v < piece.mesh.vertices.size(); ++v)
            for (const double c : piece.mesh.colours[v]) EXPECT_EQ(c, std::clamp(c, 0., 1.));
        const FragmentSurfaces again = cut(piece.mesh, 0.03, 4);
        EXPECT_EQ(faultOfCut(piece.mesh, again), "");
        for (const FragmentSurface& smaller : again.pieces) {
            expectInherited(piece.mesh, smaller, kept, parts);
            expectUsableCracks(smaller);
            EXPECT_EQ(smaller.mesh.materials, piece.mesh.materials);
            for (const int parent : smaller.parents)
                cracks_again += parent >= 0 && piece.mesh.kinds[parent] == SurfaceKind::crack;
        }
    }
    EXPECT_GT(kept, 500);
    EXPECT_GT(parts, 500);
    EXPECT_GT(cracks_again, 100);
}

TEST(Attributes, ColoursAreInterpolatedAndSpreadIntoTheCracks) {
    const TriangleMesh body = plate();
    const FragmentSurfaces fragments = cut(body, 1 / 22.0, 8);
    std::map<std::array<double, 3>, Vec3> seen;
    int inner = 0;
    for (const FragmentSurface& piece : fragments.pieces) {
        const TriangleMesh& mesh = piece.mesh;
        ASSERT_EQ(mesh.colours.size(), mesh.vertices.size());
        std::vector<char> on_body(mesh.vertices.size(), false);
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            if (piece.parents[t] >= 0)
                for (int v : mesh.triangles[t]) on_body[v] = true;
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
            const Vec3& x = mesh.vertices[v];
            EXPECT_LT((mesh.colours[v] - colourAt(x)).norm(), on_body[v] ? 1e-9 : 0.06) << x.transpose();
            inner += !on_body[v];
            const auto [entry, is_new] = seen.try_emplace({x.x(), x.y(), x.z()}, mesh.colours[v]);
            if (!is_new) {
                EXPECT_EQ(entry->second, mesh.colours[v]);
            }
        }
    }
    EXPECT_GT(inner, 50);
}

// A crack that nothing on the surface leads to.
TEST(Attributes, AHiddenCrackHasTheMeanColour) {
    TriangleMesh body = shapes::slab({1, 1, 1}, 3, 3, 3);
    for (const Vec3& v : body.vertices) body.colours.emplace_back(v.x() > 0, 0.5, 0);
    const Discretisation solid = particlesOnly(body, 0.1);
    FragmentLabels labels;
    labels.count = 2;
    for (const Particle& p : solid.particles) labels.of_particle.push_back(p.position.norm() < 0.25);
    const auto fragments = cutFragments(body, solid, labels, {});
    ASSERT_TRUE(fragments) << fragments.error();
    int checked = 0;
    for (const FragmentSurface& piece : fragments.value().pieces) {
        if (piece.label == 0) continue;
        for (const Vec3& colour : piece.mesh.colours) EXPECT_LT((colour - Vec3(0.5, 0.5, 0)).norm(), 1e-12);
        ++checked;
    }
    EXPECT_EQ(checked, 1);
}

TEST(Attributes, OfABodyWithTextureCoordinatesOnlyTellCracksApart) {
    TriangleMesh body = plate();
    body.normals.clear(), body.colours.clear(), body.material.clear(), body.materials.clear();
    const auto pieces = cut(body, 1 / 22.0, 3).pieces;
    ASSERT_GT(pieces.size(), 1u);
    for (const FragmentSurface& piece : pieces) {
        EXPECT_TRUE(piece.mesh.normals.empty() && piece.mesh.colours.empty());
        EXPECT_EQ(piece.mesh.materials, (std::vector<std::string>{"original", "crack"}));
        for (std::size_t t = 0; t < piece.parents.size(); ++t)
            EXPECT_EQ(piece.mesh.material[t], piece.parents[t] < 0 ? 1 : 0);
    }
}

TEST(Attributes, OfABodyWithoutAnyAreNone) {
    const auto pieces = cut(shapes::slab({1, 1, 0.09}, 12, 12, 2), 1 / 22.0, 3).pieces;
    ASSERT_GT(pieces.size(), 1u);
    for (const FragmentSurface& piece : pieces) expectEqualAttributes(piece.mesh, {});
}

}  // namespace
}  // namespace sherd
