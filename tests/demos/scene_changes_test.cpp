#include "scenes/scene_changes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "headless/arguments.h"
#include "scenes/scene_file.h"

namespace {

demo::Scene changed(const std::string& name, const std::vector<std::string>& changes) {
    auto read = demo::readScene(SHERD_SCENES "/" + name + ".json", "", changes);
    EXPECT_TRUE(read) << read.error();
    return read ? read.value() : demo::Scene();
}

std::string fault(const std::string& change) {
    const std::string path = SHERD_SCENES "/plaster_wall.json";
    const auto read = demo::readScene(path, "", {change});
    EXPECT_FALSE(read) << change;
    EXPECT_EQ(read.error().find(path + ": "), 0u) << read.error();
    return read.error().substr(std::min(read.error().size(), path.size() + 2));
}

TEST(SceneChanges, ShortKeysChangeTheFigureThatTheyName) {
    const demo::Scene scene = changed("plaster_wall", {"strength=2.5e6", "seed=12", "test_function=heaviside",
                                                       "speed=3", "collision_shape=hull", "duration=0.5",
                                                       "ball_diameter=0.3", "triangles=5000", "tilt=20"});
    const demo::BreakableBody& wall = scene.bodies.front();
    EXPECT_EQ(wall.material.tensile_strength_pa, 2.5e6);
    EXPECT_EQ(wall.material.youngs_modulus_pa, sherd::Material::plaster().youngs_modulus_pa);
    EXPECT_EQ(wall.settings.fracture.seed, 12u);
    EXPECT_EQ(wall.settings.stress.test_function, sherd::TestFunction::heaviside);
    EXPECT_EQ(wall.settings.fracture.collision_shape, sherd::CollisionShape::hull);
    EXPECT_EQ(wall.velocity, demo::Vec3(0, 0, 0));
    EXPECT_EQ(wall.turn_deg, demo::Vec3(0, 20, 0));
    EXPECT_GT(std::get<demo::Box>(wall.shape).edge_m, 0.03) << "0.0225 in the file";
    EXPECT_EQ(scene.balls.front().velocity, demo::Vec3(0, 3, 0));
    EXPECT_EQ(scene.balls.front().diameter_m, 0.3);
    EXPECT_EQ(scene.duration_s, 0.5);
}

TEST(SceneChanges, EveryShortKeyLeadsToAFieldThatTheHelpLists) {
    std::istringstream lines(demo::describeChanges());
    std::string line, help = demo::describeChanges();
    int keys = 0;
    while (std::getline(lines, line) && !line.empty()) {
        const std::size_t star = line.find("[*].");
        if (star == std::string::npos) continue;
        const std::string path = line.substr(star + 4, line.find('[', star + 4) - star - 4);
        EXPECT_NE(help.find("\n  " + path + " "), std::string::npos) << line;
        ++keys;
    }
    EXPECT_EQ(keys, 17);
}

TEST(SceneChanges, TheShortHelpFitsOnAScreen) {
    const auto help = [](const char* flag) {
        const char* line[] = {"bullet_demos/run", flag};
        return demo::parseArguments(2, line).value().help;
    };
    const std::string brief = help("--help"), all = help("--help-all");
    EXPECT_LT(std::count(brief.begin(), brief.end(), '\n'), 35);
    EXPECT_NE(brief.find("--help-all"), std::string::npos);
    EXPECT_NE(all.find("settings.fracture.fragment_count"), std::string::npos);
    EXPECT_EQ(all.rfind(brief, 0), 0u) << "and all of the short one";
}

TEST(SceneChanges, SpeedThrowsTheBodyDownWhereNoBallStrikes) {
    EXPECT_EQ(changed("coffee_cup", {"speed=2"}).bodies.front().velocity, demo::Vec3(0, 0, -2));
    EXPECT_EQ(changed("coffee_cup", {"ball_diameter=0.2"}).balls.size(), 0u);
}

TEST(SceneChanges, PathsReachEveryItemAndWhatTheFileLeavesOut) {
    const demo::Scene scene =
        changed("plaster_wall", {"bodies[*].turn_deg[2]=30", "bodies[0].material.density_kg_m3=1900",
                                 "bodies[0].settings.fracture.guide={\"kind\": \"radial\"}",
                                 "bodies[0].settings.fracture.guide.cost_along=0.5", "gravity_m_s2[2]=-1.6"});
    const demo::BreakableBody& wall = scene.bodies.front();
    EXPECT_EQ(wall.turn_deg, demo::Vec3(0, 0, 30));
    EXPECT_EQ(wall.material.density_kg_m3, 1900) << "of a material that the file gives by name";
    EXPECT_EQ(wall.settings.fracture.guide.cost_along, 0.5);
    EXPECT_EQ(scene.gravity, demo::Vec3(0, 0, -1.6));
}

TEST(SceneChanges, WrongKeyAndWrongValueSayWhatIsPossible) {
    EXPECT_EQ(
        fault("stregth=1").find("there is no key 'stregth'; choose one of: seed, speed, triangles, dur"), 0u);
    EXPECT_EQ(fault("basis=quintic"),
              "bodies[0].settings.stress.basis is \"quintic\"; choose one of: linear, quadratic, cubic.");
    EXPECT_EQ(fault("duration=0"), "duration_s is 0 but must be between 0.01 and 60 s.");
    EXPECT_EQ(fault("speed=1e300"), "speed is 1e+300 but must be between 0 and 100 m/s.");
    EXPECT_EQ(fault("coffee_cup"), "'coffee_cup' is not KEY=VALUE; the scene goes before --set.");
    EXPECT_EQ(fault("strength=2MPa"),
              "bodies[0].material.tensile_strength_pa must be a number, not \"2MPa\".");
    for (const char* wrong : {"seed=1.5", "seed=-1", "seed=", "strength=nan", "speed=fast", "strength=0"})
        fault(wrong);
}

TEST(Arguments, UnknownSceneNamesThoseThereAre) {
    const char* const wrong[] = {"run", "tea_cup", "--scenes", SHERD_SCENES};
    EXPECT_EQ(demo::parseArguments(4, wrong).error(),
              "There is no scene 'tea_cup'; choose one of: coffee_cup, coffee_plate, glass_wall, plane, "
              "plaster_wall, wood_wall, or name a file that ends in .json; a mesh is named with its ending, "
              "as mug.obj, and takes --view.");
}

TEST(Arguments, TakeSceneKeysAndSeed) {
    const char* const line[] = {"run",          "plaster_wall",
                                "--set",        "spacing=0.1",
                                "strength=1e6", "balls[0].position_m[2]=0.7",
                                "--seed",       "3",
                                "--scenes",     SHERD_SCENES};
    const auto parsed = demo::parseArguments(10, line);
    ASSERT_TRUE(parsed) << parsed.error();
    const demo::BreakableBody& wall = parsed.value().scene.bodies.front();
    EXPECT_EQ(wall.settings.sampling.spacing_m, 0.1);
    EXPECT_EQ(wall.material.tensile_strength_pa, 1e6);
    EXPECT_EQ(wall.settings.fracture.seed, 3u);
    EXPECT_EQ(parsed.value().scene.balls.front().position.z(), 0.7);
}

TEST(Arguments, TheLastFolderCountsAndASceneMayFollowItsKeys) {
    const char* const line[] = {"run",          "--out", "first", "--set",    "spacing=0.1",
                                "plaster_wall", "--out", "last",  "--scenes", SHERD_SCENES};
    const auto parsed = demo::parseArguments(10, line);
    ASSERT_TRUE(parsed) << parsed.error();
    EXPECT_EQ(parsed.value().out, "last");
    EXPECT_EQ(parsed.value().scene.name, "plaster_wall");
    EXPECT_EQ(parsed.value().scene.bodies.front().settings.sampling.spacing_m, 0.1);
}

TEST(Arguments, PathThatLeadsNowhereSaysWhere) {
    const char* const item[] = {"run",      "plaster_wall", "--set", "balls[3].position_m[2]=1",
                                "--scenes", SHERD_SCENES};
    EXPECT_NE(demo::parseArguments(6, item).error().find(
                  "balls[3].position_m[2] leads to an item that is not there; its list has 1."),
              std::string::npos);
    const char* const key[] = {"run",      "plaster_wall", "--set", "bodies[0].spacing=1",
                               "--scenes", SHERD_SCENES};
    EXPECT_NE(
        demo::parseArguments(6, key).error().find("bodies[0].spacing is not a key; choose one of: shape,"),
        std::string::npos);
}

}  // namespace
