#include "scenes/scene_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "scenes/scenes.h"
#include "support/temporary_path.h"

namespace {

namespace fs = std::filesystem;
using demo::Vec3;

/// A scene file in a folder of its own.
std::string written(const std::string& text) {
    const fs::path folder = temporaryPath("scenes");
    fs::create_directories(folder);
    std::ofstream(folder / "mine.json") << text;
    return (folder / "mine.json").string();
}

std::string body(const std::string& more = "") {
    return R"({"shape": {"box": {"size_m": [1, 1, 1]}}, "material": "plaster")" + more + "}";
}

std::string scene(const std::string& more, const std::string& bodies = body()) {
    return R"({"bodies": [)" + bodies + "]" + more + "}";
}

/// What is said about the text, without the file's name.
std::string fault(const std::string& text, const std::string& preset = "") {
    const std::string path = written(text);
    const auto read = demo::readScene(path, preset);
    if (read) return "";
    EXPECT_EQ(read.error().find(path + ": "), 0u) << read.error();
    return read.error().substr(path.size() + 2);
}

TEST(SceneFiles, EveryOneOfTheTreeLoadsWithEveryPreset) {
    int loaded = 0;
    for (const std::string& file : demo::sceneFiles(SHERD_SCENES)) {
        const auto plain = demo::readScene(file);
        ASSERT_TRUE(plain) << plain.error();
        EXPECT_FALSE(plain.value().summary.empty()) << file;
        for (const std::string& preset : plain.value().presets) {
            const auto changed = demo::readScene(file, preset);
            ASSERT_TRUE(changed) << changed.error();
            EXPECT_EQ(changed.value().time_step_s, 0.001);
            EXPECT_EQ(changed.value().bodies[0].material.poisson_ratio, 0.43);
            EXPECT_EQ(changed.value().bodies[0].material.youngs_modulus_pa, 5e9);
            ++loaded;
        }
    }
    EXPECT_EQ(loaded, 6);
}

TEST(SceneFiles, SayWhatTheSceneHolds) {
    const auto read = demo::readScene(written(scene(
        R"(, "seed": 5, "duration_s": 3, "gravity_m_s2": [0, 0, -1.6], "floor": {"friction": 0.1},
           "balls": [{"diameter_m": 0.3, "velocity_m_s": [0, 4, 0]}])",
        R"({"shape": {"obj": "../thing.obj", "repair": "automatic", "scale": 0.001, "up_axis": "y",
                      "shell_thickness_m": 0.003},
            "turn_deg": [0, 90, 0], "velocity_m_s": [0, 0, -2], "spin_rad_s": [1, 0, 0],
            "material": {"like": "glass", "density_kg_m3": 2600, "failure_criterion": "mohr_coulomb"},
            "look": {"gloss": 0.5},
            "settings": {"quality": "film", "sampling": {"smallest_count": 3000},
                         "stress": {"resampling_rounds": 1},
                         "fracture": {"contact": {"smallest_patch": 0.3}, "fragment_count": 7,
                                      "guide": {"kind": "radial", "cost_along": 0.1}}}})")));
    ASSERT_TRUE(read) << read.error();
    const demo::Scene& scene = read.value();
    const demo::BreakableBody& thing = scene.bodies.at(0);
    EXPECT_EQ(scene.name, "mine");
    EXPECT_EQ(scene.duration_s, 3);
    EXPECT_EQ(scene.gravity, Vec3(0, 0, -1.6));
    EXPECT_EQ(scene.floor.friction, 0.1);
    EXPECT_EQ(scene.balls.at(0).velocity, Vec3(0, 4, 0));
    EXPECT_EQ(fs::path(std::get<demo::ObjFile>(thing.shape).path),
              (fs::path(testing::TempDir()) / "thing.obj").lexically_normal());
    const sherd::Repair& repair = std::get<demo::ObjFile>(thing.shape).repair;
    EXPECT_EQ(repair.mode, sherd::Repair::Mode::automatic);
    EXPECT_EQ(repair.scale, 0.001);
    EXPECT_EQ(repair.up_axis, sherd::UpAxis::y);
    EXPECT_EQ(repair.shell_thickness_m, 0.003);
    EXPECT_EQ(thing.material.density_kg_m3, 2600);
    EXPECT_EQ(thing.material.failure_criterion, "mohr_coulomb");
    EXPECT_EQ(thing.material.youngs_modulus_pa, sherd::Material::glass().youngs_modulus_pa);
    EXPECT_EQ(thing.spin, Vec3(1, 0, 0));
    EXPECT_EQ(thing.look.gloss, 0.5);
    EXPECT_EQ(thing.look.outside, demo::lookOf(sherd::Material::glass()).outside) << "of the material";
    EXPECT_EQ(thing.settings.stress.resampling_error, 0.05) << "of the film quality";
    EXPECT_EQ(thing.settings.stress.resampling_rounds, 1);
    EXPECT_EQ(thing.settings.sampling.smallest_count, 3000);
    EXPECT_EQ(thing.settings.fracture.contact.smallest_patch, 0.3);
    EXPECT_EQ(thing.settings.fracture.seed, 5u);
    EXPECT_EQ(thing.settings.fracture.fragment_count, 7);
    EXPECT_EQ(thing.settings.fracture.guide.kind, sherd::GuideField::Kind::radial);
}

TEST(SceneFiles, PresetsChangeWhatTheyNameAndTakeAwayNull) {
    const std::string text = scene(R"(, "duration_s": 3, "presets": {"moon": {"gravity_m_s2": [0, 0, -1.6],
        "bodies": [{"shape": {"box": null, "obj": "rock.obj"}}]}})");
    const auto read = demo::readScene(written(text), "moon");
    ASSERT_TRUE(read) << read.error();
    EXPECT_EQ(read.value().gravity.z(), -1.6);
    EXPECT_EQ(read.value().duration_s, 3);
    EXPECT_TRUE(std::holds_alternative<demo::ObjFile>(read.value().bodies[0].shape));
    EXPECT_EQ(fault(text, "sun"), "there is no preset 'sun'; choose one of: moon.");
    EXPECT_EQ(fault(scene(""), "sun"), "there is no preset 'sun'; this scene has none.");
}

TEST(SceneFiles, MisspeltKeysNameThoseThereAre) {
    EXPECT_EQ(fault(scene(R"(, "durration_s": 1)")),
              "durration_s is not a key; choose one of: summary, floor, camera, gravity_m_s2, duration_s, "
              "after_picture_s, time_step_s, seed, bodies, balls.");
    EXPECT_EQ(fault(scene("", R"({"shape": {"sphere": 1}, "material": "plaster"})")),
              "bodies[0].shape must have one of obj, box and generator.");
    EXPECT_EQ(fault(scene("", body(R"(, "look": {"colour": [1, 1, 1]})"))),
              "bodies[0].look.colour is not a key; choose one of: outside, crack, gloss.");
    EXPECT_EQ(fault(scene("", body(R"(, "settings": {"fracture": {"guide": {"kind": "spiral"}}})"))),
              "bodies[0].settings.fracture.guide.kind is \"spiral\"; choose one of: none, constant, radial.");
    EXPECT_EQ(fault(scene("", body(R"(, "settings": {"fracture": {"collision_shape": "mesh"}})"))),
              "bodies[0].settings.fracture.collision_shape is \"mesh\"; choose one of: automatic, boxes, "
              "hull, convex_parts.");
    EXPECT_EQ(fault(scene("", R"({"shape": {"generator": "teapot"}, "material": "ice"})")),
              "bodies[0].shape.generator is \"teapot\"; choose one of: coffee_cup, coffee_plate, plane.");
    EXPECT_EQ(
        fault(scene("", R"({"shape": {"obj": "a.obj"}, "material": "jelly"})")),
        "bodies[0].material: There is no material 'jelly'; there are ceramic, plaster, glass, "
        "concrete, brick, stone, ice, wood. Or give the constants in braces, or a file of them that ends "
        "in .json.");
}

TEST(SceneFiles, PaintedStrengthIsOfTheBody) {
    const auto painted = demo::readScene(written(scene("", body(R"(, "painted_strength": {"black": 0.1})"))));
    ASSERT_TRUE(painted) << painted.error();
    EXPECT_EQ(painted.value().bodies[0].painted_strength->black, 0.1);
    EXPECT_EQ(painted.value().bodies[0].painted_strength->white, 1);
    EXPECT_FALSE(demo::readScene(written(scene(""))).value().bodies[0].painted_strength);
    EXPECT_EQ(fault(scene("", body(R"(, "painted_strength": {"black": 0})"))),
              "bodies[0].painted_strength.black is 0 but must be between 0.001 and 1000.");
}

TEST(SceneFiles, SupportsAreRegionsOfTheBodysSurface) {
    const auto held = demo::readScene(written(scene("", body(R"(, "supports": [
        {"box": {"lo_m": [-1, -1, -0.5], "hi_m": [1, 2, -0.5]}},
        {"sphere": {"centre_m": [0, 0, 0.5], "radius_m": 0.1}},
        {"cylinder": {"point_m": [0.1, 0, 0], "axis": [0, 1, 0], "radius_m": 0.02}}])"))));
    ASSERT_TRUE(held) << held.error();
    const std::vector<sherd::SurfaceRegion>& supports = held.value().bodies[0].supports;
    ASSERT_EQ(supports.size(), 3u);
    EXPECT_EQ(std::get<sherd::BoxRegion>(supports[0]).lo, Vec3(-1, -1, -0.5));
    EXPECT_EQ(std::get<sherd::BoxRegion>(supports[0]).hi, Vec3(1, 2, -0.5));
    EXPECT_EQ(std::get<sherd::SphereRegion>(supports[1]).centre, Vec3(0, 0, 0.5));
    EXPECT_EQ(std::get<sherd::SphereRegion>(supports[1]).radius_m, 0.1);
    EXPECT_EQ(std::get<sherd::CylinderRegion>(supports[2]).point, Vec3(0.1, 0, 0));
    EXPECT_EQ(std::get<sherd::CylinderRegion>(supports[2]).axis, Vec3(0, 1, 0));
    EXPECT_EQ(std::get<sherd::CylinderRegion>(supports[2]).radius_m, 0.02);
}

TEST(SceneFiles, SupportsThatSayNoRegionAreRefused) {
    const auto refused = [](const std::string& supports) {
        return fault(scene("", body(R"(, "supports": )" + supports)));
    };
    EXPECT_EQ(refused("{}"), "bodies[0].supports must be a list in brackets, not {}.");
    EXPECT_EQ(refused("[{}]"), "bodies[0].supports[0] must have one of sphere, box and cylinder.");
    EXPECT_EQ(refused(R"([{"box": {"lo_m": [0, 0, 0]}}])"),
              "bodies[0].supports[0].box.hi_m is missing; it is the opposite corner.");
    EXPECT_EQ(refused(R"([{"sphere": {"centre_m": [0, 0, 0], "radius_m": 0}}])"),
              "bodies[0].supports[0].sphere.radius_m is 0 but must be between 1e-06 and 1000 m.");
    EXPECT_EQ(refused(R"([{"box": {"lo_m": [0, 0, 0], "hi_m": [1, 1, 0]}}], "velocity_m_s": [1, 0, 0])"),
              "bodies[0].supports hold the body where it is, so velocity_m_s and spin_rad_s must be zero.");
}

TEST(SceneFiles, AMaterialMayHaveAFileOfItsOwn) {
    const std::string path = written(scene("", R"({"shape": {"obj": "a.obj"}, "material": "tile.json"})"));
    std::ofstream(fs::path(path).parent_path() / "tile.json")
        << R"({"like": "ceramic", "density_kg_m3": 2222})";
    const auto tile = demo::readScene(path);
    ASSERT_TRUE(tile) << tile.error();
    EXPECT_EQ(tile.value().bodies[0].material.density_kg_m3, 2222);
    std::ofstream(fs::path(path).parent_path() / "tile.json")
        << R"({"like": "ceramic", "density_kg_m3": -1})";
    EXPECT_NE(demo::readScene(path).error().find("tile.json: density_kg_m3 is -1 but must be positive"),
              std::string::npos);
}

TEST(SceneFiles, ABodyMayHaveASeedOfItsOwn) {
    const auto read = demo::readScene(
        written(scene(R"(, "seed": 5)", body() + "," + body(R"(, "settings": {"fracture": {"seed": 8}})"))));
    ASSERT_TRUE(read) << read.error();
    EXPECT_EQ(read.value().bodies[0].settings.fracture.seed, 5u);
    EXPECT_EQ(read.value().bodies[1].settings.fracture.seed, 8u);
    for (const demo::BreakableBody& each : read.value().bodies) EXPECT_EQ(each.settings.strength.seed, 5u);
}

TEST(SceneFiles, GuidesWithoutAKindAreRefused) {
    EXPECT_EQ(fault(scene("", body(R"(, "settings": {"fracture": {"guide": {"direction": [1, 0, 0]}}})"))),
              "bodies[0].settings.fracture.guide.kind is missing; choose one of: none, constant, radial.");
}

TEST(SceneFiles, WrongTypesSayWhatIsTaken) {
    EXPECT_EQ(fault(scene(R"(, "duration_s": "long")")), "duration_s must be a number, not \"long\".");
    EXPECT_EQ(fault(scene(R"(, "seed": 1.5)")), "seed must be a whole number, not 1.5.");
    EXPECT_EQ(fault(scene(R"(, "balls": {})")), "balls must be a list in brackets, not {}.");
    EXPECT_EQ(fault(scene(R"(, "floor": 1)")), "floor must be an object in braces, not 1.");
    EXPECT_EQ(fault(scene(R"(, "gravity_m_s2": [0, -9.8])")),
              "gravity_m_s2 must be a list of three numbers, not [0,-9.8].");
    EXPECT_EQ(fault(scene("", body(R"(, "settings": {"stress": {"resample_contacts": 1}})"))),
              "bodies[0].settings.stress.resample_contacts must be true or false, not 1.");
    EXPECT_EQ(fault("[1]"), "the file must be an object in braces, not [1].");
    EXPECT_EQ(fault("{}"), "bodies must have at least one body that can break.");
}

TEST(SceneFiles, ImpossibleValuesSayWhatIsPossible) {
    EXPECT_EQ(fault(scene(R"(, "time_step_s": 0)")),
              "time_step_s is 0 but must be between 0.0001 and 0.0333333 s.");
    EXPECT_EQ(fault(scene(R"(, "seed": -1)")), "seed is -1 but must be between 0 and 1e+09.");
    EXPECT_EQ(fault(scene(R"(, "camera": {"towards": [0, 0, -1]})")),
              "camera.towards must not be straight up or down, nor zero.");
    const std::string constants =
        R"("youngs_modulus_pa": 5e9, "poisson_ratio": 0.2, "tensile_strength_pa": 3e6)";
    EXPECT_EQ(fault(scene("", R"({"shape": {"obj": "a.obj"}, "material": {)" + constants +
                                  R"(, "fracture_energy_j_m2": 10, "density_kg_m3": -5}})")),
              "bodies[0].material.density_kg_m3 is -5 but must be positive, in kg/m^3.");
    EXPECT_EQ(
        fault(scene("", R"({"shape": {"obj": "a.obj"}, "material": {)" + constants + "}}")),
        "bodies[0].material.density_kg_m3 is missing; give it, or the material that gives it as \"like\".");
    EXPECT_EQ(fault(scene("", body(R"(, "settings": {"sampling": {"spacing_m": -1}})"))),
              "bodies[0].settings.sampling.spacing_m is -1 but must be 0 (chosen from the wall thickness) or "
              "positive, in m.");
    EXPECT_EQ(
        fault(scene("", body(R"(, "position_m": [0, 0, -1])"))),
        "bodies[0].position_m[2] must not be negative: it is the height of the lowest point over the floor.");
}

TEST(SceneFiles, WhatIsNoJsonSaysWhere) {
    EXPECT_NE(fault("{\n  \"bodies\": [\n}").find("this is not JSON: "), std::string::npos);
    EXPECT_NE(fault("{\n  \"bodies\": [\n}").find("line 3"), std::string::npos);
    EXPECT_EQ(fault(R"({"seed": 1, "seed": 2})"), "the key \"seed\" is twice in one object; keep one.");
    const std::string deep = std::string(1000000, '[') + std::string(1000000, ']');
    EXPECT_EQ(fault(scene(", \"seed\": " + deep)), "values are nested deeper than 100 times.");
    EXPECT_FALSE(demo::readScene(written(scene("")), "", {"seed=" + deep}));
    EXPECT_EQ(demo::readScene("nowhere.json").error(), "nowhere.json: the scene file cannot be opened.");
    EXPECT_EQ(fault(scene(R"(, /* a comment */ "seed": 1 // and another
)")),
              "");
}

}  // namespace
