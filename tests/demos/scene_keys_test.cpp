#include "headless/scene_keys.h"

#include <gtest/gtest.h>

#include "headless/arguments.h"
#include "scenes/scene_file.h"

namespace {

demo::Scene named(const std::string& name) {
    auto read = demo::readScene(SHERD_SCENES "/" + name + ".json");
    EXPECT_TRUE(read) << read.error();
    return read.value();
}

demo::Scene scene() {
    return named("plaster_wall");
}

TEST(SceneKeys, ChangeTheFigureThatTheyName) {
    demo::Scene changed = scene();
    ASSERT_TRUE(demo::applyKey(changed, "strength=2.5e6"));
    ASSERT_TRUE(demo::applyKey(changed, "seed=12"));
    ASSERT_TRUE(demo::applyKey(changed, "test_function=heaviside"));
    ASSERT_TRUE(demo::applyKey(changed, "speed=3"));
    ASSERT_TRUE(demo::applyKey(changed, "collision_shape=hull"));
    const demo::BreakableBody& wall = changed.bodies.front();
    EXPECT_EQ(wall.material.tensile_strength_pa, 2.5e6);
    EXPECT_EQ(wall.settings.fracture.seed, 12u);
    EXPECT_EQ(wall.settings.stress.test_function, sherd::TestFunction::heaviside);
    EXPECT_EQ(wall.settings.fracture.collision_shape, sherd::CollisionShape::hull);
    EXPECT_EQ(changed.balls.front().velocity, demo::Vec3(0, 3, 0));
    EXPECT_EQ(wall.velocity, demo::Vec3(0, 0, 0));
}

TEST(SceneKeys, SpeedThrowsTheBodyDownWhereNoBallStrikes) {
    demo::Scene cup = named("coffee_cup");
    ASSERT_TRUE(demo::applyKey(cup, "speed=2"));
    EXPECT_EQ(cup.bodies.front().velocity, demo::Vec3(0, 0, -2));
}

TEST(SceneKeys, WrongKeyAndWrongValueSayWhatIsPossible) {
    demo::Scene changed = scene();
    EXPECT_NE(
        demo::applyKey(changed, "stregth=1").error().find("There is no key 'stregth'; choose one of: seed,"),
        std::string::npos);
    EXPECT_EQ(demo::applyKey(changed, "basis=quintic").error(),
              "'quintic' is not possible for basis; it takes linear, quadratic, cubic.");
    EXPECT_EQ(demo::applyKey(changed, "duration=0").error(),
              "'0' is not possible for duration; it takes 0.01 to 60 s.");
    EXPECT_EQ(demo::applyKey(changed, "coffee_cup").error(),
              "'coffee_cup' is not KEY=VALUE; a scene's name goes before --set.");
    for (const char* wrong :
         {"seed=1.5", "seed=-1", "seed=", "strength=nan", "strength=2MPa", "speed=1e300"}) {
        EXPECT_FALSE(demo::applyKey(changed, wrong).ok()) << wrong;
    }
}

TEST(Arguments, UnknownSceneNamesThoseThereAre) {
    const char* const wrong[] = {"run", "tea_cup", "--scenes", SHERD_SCENES};
    EXPECT_EQ(demo::parseArguments(4, wrong).error(),
              "There is no scene 'tea_cup'; choose one of: coffee_cup, coffee_plate, glass_wall, plane, "
              "plaster_wall, "
              "wood_wall, or name a file that ends in .json.");
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
