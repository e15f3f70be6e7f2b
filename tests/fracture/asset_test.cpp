#include <gtest/gtest.h>
#include <sherd/breakable_asset.h>

#include <cmath>
#include <limits>

#include "core/mlpg/stress_solver.h"
#include "fracture/breakable_solid.h"
#include "support/shapes.h"

namespace {

using namespace sherd;

std::string sentenceFor(const std::string& file) {
    return BreakableAsset::fromObj(std::string(SHERD_TEST_DATA) + "/bad_obj/" + file, Material::ceramic())
        .error();
}

TEST(Asset, EveryKindOfWrongObjHasItsOwnSentence) {
    const std::vector<std::pair<std::string, std::string>> expected = {
        {"open.obj", "is open"},   {"inverted.obj", "inward"},  {"self_intersecting.obj", "intersect"},
        {"empty.obj", "no faces"}, {"nan.obj", "not a finite"}, {"not_there.obj", "cannot be opened"}};
    for (const auto& [file, words] : expected) {
        const std::string sentence = sentenceFor(file);
        EXPECT_NE(sentence.find(words), std::string::npos) << file << ": " << sentence;
        EXPECT_NE(sentence.find(file), std::string::npos) << sentence;
        EXPECT_EQ(sentence.back(), '.') << sentence;
        const bool mendable = file == "open.obj" || file == "inverted.obj" || file == "self_intersecting.obj";
        EXPECT_EQ(sentence.find("Repair::automatic()") != std::string::npos, mendable) << sentence;
    }
}

TEST(Asset, MeshesAsTheyComeAreMendedWhereThatIsAskedFor) {
    const std::string folder = std::string(SHERD_TEST_DATA) + "/bad_obj/";
    for (const std::string file : {"open.obj", "inverted.obj", "self_intersecting.obj"}) {
        const auto asset =
            BreakableAsset::fromObj(folder + file, Material::ceramic(), {}, Repair::automatic());
        ASSERT_TRUE(asset.ok()) << asset.error();
        EXPECT_TRUE(asset.value().repairs().changed()) << file;
        EXPECT_GT(asset.value().volume(), 0);
    }
}

TEST(Asset, SizesThatAreHardlyMeantAreWarnedOf) {
    const auto warnings = [](double scale) {
        Repair repair;
        repair.scale = scale;
        const auto asset = BreakableAsset::fromMesh(shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 1)),
                                                    Material::glass(), {}, repair);
        return asset.ok() ? asset.value().warnings() : std::vector<std::string>{asset.error()};
    };
    EXPECT_TRUE(warnings(1).empty());
    ASSERT_EQ(warnings(30).size(), 1u);
    EXPECT_NE(warnings(30)[0].find("30 m long"), std::string::npos) << warnings(30)[0];
    ASSERT_EQ(warnings(0.003).size(), 1u);
    EXPECT_NE(warnings(0.003)[0].find("Repair::scale"), std::string::npos) << warnings(0.003)[0];
}

TEST(Asset, SolidsThatDoNotTouchAreWarnedOf) {
    const auto warnings = [](const TriangleMesh& mesh) {
        const auto asset = BreakableAsset::fromMesh(mesh, Material::glass());
        return asset.ok() ? asset.value().warnings() : std::vector<std::string>{asset.error()};
    };
    const TriangleMesh box = shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    const std::vector<std::string> of_two =
        warnings(shapes::joined(box, shapes::translated(box, Vec3(1.5, 0, 0))));
    ASSERT_EQ(of_two.size(), 1u);
    EXPECT_NE(of_two[0].find("2 solids"), std::string::npos) << of_two[0];
    const TriangleMesh hollow =
        shapes::joined(box, shapes::inverted(shapes::box(Vec3(0.2, 0.2, 0.2), Vec3(0.8, 0.8, 0.8))));
    EXPECT_TRUE(warnings(hollow).empty());
}

TEST(Asset, MaterialsThatAreHardlyMeantAreWarnedOf) {
    const auto warnings = [](void (*change)(Material&)) {
        Material material = Material::glass();
        change(material);
        const auto asset = BreakableAsset::fromMesh(shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 1)), material);
        return asset.ok() ? asset.value().warnings() : std::vector<std::string>{asset.error()};
    };
    ASSERT_EQ(warnings([](Material& m) { m.youngs_modulus_pa = 70; }).size(), 1u);
    EXPECT_EQ(
        warnings([](Material& m) { m.youngs_modulus_pa = 70; })[0],
        "The material's youngs_modulus_pa is 70, less than that of any usual one; is it in Pa, not in GPa "
        "or MPa?");
    EXPECT_EQ(warnings([](Material& m) { m.tensile_strength_pa = 40; }).size(), 1u);
    EXPECT_EQ(warnings([](Material& m) { m.density_kg_m3 = 2.5; }).size(), 1u);
    EXPECT_EQ(warnings([](Material& m) { m = m.withDensity(1e-3); }).size(), 0u) << "as it was asked for";
}

TEST(Asset, ColoursThatAreNoNumbersAreNamed) {
    TriangleMesh mesh = shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    mesh.colours.assign(mesh.vertices.size(), Vec3(1, 1, 1));
    mesh.colours[3].y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(BreakableAsset::fromMesh(mesh, Material::glass()).error(),
              "The colour of vertex 3 of the surface is not a finite number; correct it.");
}

TEST(Asset, CornersThatAreNoNumbersAreNamed) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    TriangleMesh mesh = shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    mesh.normals.assign(mesh.triangles.size(), {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()});
    mesh.texture_coordinates.assign(mesh.triangles.size(), {Vec2::Zero(), Vec2::Zero(), Vec2::Zero()});
    EXPECT_TRUE(BreakableAsset::fromMesh(mesh, Material::glass()).ok());
    mesh.normals[5][2].x() = nan;
    EXPECT_EQ(BreakableAsset::fromMesh(mesh, Material::glass()).error(),
              "The normals of triangle 5 of the surface are not finite numbers; correct them, or leave the "
              "list empty.");
    mesh.texture_coordinates[7][0].y() = nan;
    EXPECT_EQ(BreakableAsset::fromMesh(mesh, Material::glass()).error(),
              "The texture coordinates of triangle 7 of the surface are not finite numbers; correct them, or "
              "leave the list empty.");
}

// The foot is narrower than a particle spacing, by far. A push of 1 N along the upper edge stores what it
// does in a clamped plate: between F^2 L^3 / (6 E I) of a beam and that times 1 - nu^2.
TEST(Asset, ThinPanesAreHeldAtTheirFoot) {
    for (const double thickness : {0.004, 0.01, 0.02}) {
        const double length = 0.8;
        const auto pane = BreakableAsset::fromMesh(
                              shapes::box(Vec3(0, 0, 0), Vec3(length, thickness, length)), Material::glass())
                              .value();
        const auto held = pane.anchored({BoxRegion{{-1, -1, 0}, {1, 1, 0}}});
        ASSERT_TRUE(held.ok()) << thickness << ": " << held.error();
        const auto solver = held.value().solid()->stressSolver();
        ASSERT_TRUE(solver.ok()) << thickness << ": " << solver.error();
        std::vector<PointForce> push;
        constexpr int points = 80;
        for (int i = 0; i < points; ++i)
            push.push_back(
                {Vec3((i + 0.5) / points * length, thickness / 2, 0.999 * length), Vec3(0, 1.0 / points, 0)});
        const auto stress = solver.value()->solve(push);
        ASSERT_TRUE(stress.ok()) << stress.error();
        const double inertia = length * std::pow(thickness, 3) / 12;
        const double beam = std::pow(length, 3) / (6 * Material::glass().youngs_modulus_pa * inertia);
        EXPECT_GT(stress.value().strain_energy_j, 0.9 * beam) << thickness;
        EXPECT_LT(stress.value().strain_energy_j, 1.02 * beam) << thickness;
    }
}

TEST(Asset, ASupportThatHoldsAllOfTheSurfaceIsRefused) {
    const BreakableAsset block =
        BreakableAsset::fromMesh(shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 1)), Material::plaster()).value();
    const auto held = block.anchored({BoxRegion{{-2, -2, 0}, {2, 2, 0}}, BoxRegion{{-1, -1, -1}, {2, 2, 2}}});
    ASSERT_FALSE(held.ok());
    EXPECT_EQ(
        held.error(),
        "nothing can come loose of the body, since the box from (-1, -1, -1) m to (2, 2, 2) m holds all "
        "of its surface; name the parts by which it is held, in m and in the coordinates of its mesh");
    EXPECT_TRUE(block.anchored({BoxRegion{{-1, -1, -1}, {2, 2, 0.99}}}).ok()) << "one face is free";
    TriangleMesh piece = shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    piece.kinds.assign(piece.triangles.size(), SurfaceKind::original);
    piece.kinds.front() = SurfaceKind::crack;
    EXPECT_TRUE(BreakableAsset::fromMesh(piece, Material::plaster())
                    .value()
                    .anchored({BoxRegion{{-1, -1, -1}, {2, 2, 2}}})
                    .ok())
        << "crack faces are held by nothing";
}

TEST(Asset, BodiesThatAreHeldAlikeShareWhatIsMadeOnce) {
    const BreakableAsset block =
        BreakableAsset::fromMesh(shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 1)), Material::plaster()).value();
    const std::vector<SurfaceRegion> foot{BoxRegion{{-2, -2, 0}, {2, 2, 0}}},
        top{BoxRegion{{-2, -2, 1}, {2, 2, 1}}}, corner{SphereRegion{Vec3(0, 0, 0), 0.4}};
    const BreakableAsset held = block.anchored(foot).value();
    EXPECT_EQ(block.anchored(foot).value().solid(), held.solid());
    EXPECT_NE(block.anchored(top).value().solid(), held.solid());
    EXPECT_NE(block.anchored(corner).value().solid(), held.solid());
    EXPECT_NE(block.ofBody(7).anchored(foot).value().solid(), held.solid())
        << "its strength scatters in another way";
    std::weak_ptr<const BreakableSolid> kept;
    {
        const BreakableAsset passing = block.anchored(top).value();
        kept = passing.solid();
    }
    EXPECT_TRUE(kept.expired());
}

TEST(Asset, ConstantsOutOfRangeAreNamed) {
    const TriangleMesh box = shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    const auto sentence = [&](void (*spoil)(Material&)) {
        Material material = Material::glass();
        spoil(material);
        return BreakableAsset::fromMesh(box, material).error();
    };
    EXPECT_NE(sentence([](Material& m) { m.poisson_ratio = 0.5; }).find("poisson_ratio"), std::string::npos);
    EXPECT_NE(sentence([](Material& m) { m.density_kg_m3 = 0; }).find("density"), std::string::npos);
    EXPECT_NE(sentence([](Material& m) { m.tensile_strength_pa = -1; }).find("tensile_strength"),
              std::string::npos);
    EXPECT_NE(sentence([](Material& m) {
                  m.youngs_modulus_pa = std::numeric_limits<double>::quiet_NaN();
              }).find("youngs_modulus"),
              std::string::npos);
    Settings settings;
    settings.sampling.spacing_m = -1;
    EXPECT_NE(BreakableAsset::fromMesh(box, Material::glass(), settings).error().find("spacing_m"),
              std::string::npos);
}

TEST(Asset, SpacingGivenIsSpacingUsed) {
    // The paper's wall (section 7, Table 1): 968 particles.
    Settings settings;
    settings.sampling.spacing_m = 0.045;
    const auto wall = BreakableAsset::fromMesh(shapes::box(Vec3(-0.5, -0.5, 0), Vec3(0.5, 0.5, 0.09)),
                                               Material::plaster(), settings);
    ASSERT_TRUE(wall.ok()) << wall.error();
    EXPECT_EQ(wall.value().particleCount(), 968);
    EXPECT_NEAR(wall.value().volume(), 0.09, 1e-12);
    EXPECT_NEAR(wall.value().mass(), 0.09 * Material::plaster().density_kg_m3, 1e-9);
}

TEST(Asset, SpacingFollowsTheWall) {
    Settings settings;
    settings.sampling.layers_across_wall = 2;
    const TriangleMesh plate = shapes::box(Vec3(-0.1, -0.1, 0), Vec3(0.1, 0.1, 0.02));
    const auto two_across = BreakableAsset::fromMesh(plate, Material::glass(), settings);
    ASSERT_TRUE(two_across.ok());
    EXPECT_EQ(two_across.value().particleCount(), 20 * 20 * 2);

    // No finer than its factor may be large.
    settings.sampling.largest_factor_millions = settings.sampling.largest_factor_if_thin_millions = 1;
    const auto cheap = BreakableAsset::fromMesh(plate, Material::glass(), settings);
    ASSERT_TRUE(cheap.ok());
    EXPECT_LT(cheap.value().particleCount(), 400);
    EXPECT_GT(cheap.value().particleCount(), 50);
}

}  // namespace
