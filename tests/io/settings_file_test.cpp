#include <gtest/gtest.h>
#include <sherd/settings.h>

#include <fstream>

#include "support/altered_fields.h"
#include "support/temporary_path.h"

namespace {

using namespace sherd;

TEST(SettingsFile, StartsFromAQualityAndChangesWhatItGives) {
    const std::string path = temporaryPath("settings.json");
    std::ofstream(path) << R"({"quality": "film", "stress": {"resampling_rounds": 1},
        "fracture": {"guide": {"kind": "constant", "direction": [1, 0, 0]}, "debris": "merged", "seed": 9}})";
    const auto read = Settings::fromJsonFile(path);
    ASSERT_TRUE(read.ok()) << read.error();
    EXPECT_EQ(read.value().stress.resampling_error, 0.05);
    EXPECT_EQ(read.value().stress.resampling_rounds, 1);
    EXPECT_EQ(read.value().fracture.guide.direction, Vec3(1, 0, 0));
    EXPECT_EQ(read.value().fracture.debris, Debris::merged);
    EXPECT_EQ(read.value().fracture.seed, 9u);
}

TEST(SettingsFile, ReadsBackWhatItWrites) {
    Settings altered;
    alterFields(altered);
    ASSERT_EQ(altered.validate().error(), "");
    for (const Settings& written : {altered, Settings()}) {
        const auto read_back = Settings::fromJson(written.toJson());
        ASSERT_TRUE(read_back.ok()) << read_back.error();
        EXPECT_EQ(valuesOf(read_back.value()), valuesOf(written));
    }
}

TEST(SettingsFile, WhatIsWrongIsNamed) {
    const std::pair<const char*, const char*> wrong[] = {
        {"[]", "body.settings must be an object in braces, not []."},
        {R"({"quality": "best"})", "body.settings.quality is \"best\"; choose one of: preview, game, film."},
        {R"({"speed": 1})",
         "body.settings.speed is not a key; choose one of: quality, sampling, stress, strength, fracture."},
        {R"({"stress": {"basis": 2}})", "body.settings.stress.basis must be text in quotes, not 2."},
        {R"({"sampling": {"spacing_m": -1}})",
         "body.settings.sampling.spacing_m is -1 but must be 0 (chosen from the wall thickness) or positive, "
         "in m."},
        {R"({"sampling": {"largest_count": 5}})",
         "body.settings.sampling.largest_count is 5 but must be at least smallest_count."},
        {R"({"sampling": {"largest_count": 1e5}})",
         "body.settings.sampling.largest_count must be a whole number, not 100000.0."},
        {R"({"sampling": {"largest_count": 10000000000}})",
         "body.settings.sampling.largest_count is too large: 10000000000."},
        {R"({"sampling": {"moment_order": 2}})",
         "body.settings.sampling.moment_order is not a key; choose one of: spacing_m,"},
        {R"({"fracture": {"seed": -1}})",
         "body.settings.fracture.seed must be a whole number, 0 or positive, not -1."},
        {R"({"fracture": {"guide": {"direction": [1, 0, 0]}}})",
         "body.settings.fracture.guide.kind is missing; choose one of: none, constant, radial."},
        {R"({"fracture": {"guide": {"kind": "custom"}}})",
         "body.settings.fracture.guide.kind is \"custom\"; choose one of: none, constant, radial."},
        {R"({"fracture": {"guide": {"kind": "constant", "direction": [0, 0, 0]}}})",
         "body.settings.fracture.guide.direction is zero or not finite but must be a direction."},
        {R"({"fracture": {"guide": {"kind": "radial", "cost_along": 2}}})",
         "body.settings.fracture.guide.cost_along is 2 but must be between 0 and 1."},
    };
    for (const auto& [text, sentence] : wrong) {
        const std::string error = Settings::fromJson(text, "body.settings").error();
        EXPECT_EQ(error.find(sentence), 0u) << error << " (expected: " << sentence << ")";
    }
}

TEST(SettingsPaths, SetWhatTheyName) {
    Settings settings;
    const Status set = settings.set({"sampling.spacing_m=0.02", "stress.basis=cubic",
                                     "fracture.guide.direction=[0, 1, 0]", "stress.resample_contacts=true"});
    ASSERT_TRUE(set.ok()) << set.error();
    EXPECT_EQ(settings.sampling.spacing_m, 0.02);
    EXPECT_EQ(settings.stress.basis, Basis::cubic);
    EXPECT_EQ(settings.fracture.guide.direction, Vec3(0, 1, 0));
    EXPECT_TRUE(settings.stress.resample_contacts);
}

TEST(SettingsPaths, AreCheckedTogetherAndChangeNothingIfOneIsWrong) {
    Settings settings;
    EXPECT_TRUE(settings.set({"sampling.smallest_count=30000", "sampling.largest_count=40000"}).ok());
    EXPECT_EQ(
        settings.set({"sampling.spacing_m=0.1", "stress.support_radius=9"}).error(),
        "stress.support_radius is 9 but must be 0 (the form's own default) or between 1.2 and 4 particle "
        "spacings.");
    EXPECT_EQ(settings.sampling.spacing_m, 0);
    EXPECT_EQ(
        settings.set({"stress.base=cubic"}).error().find("stress.base is not a key; choose one of: test_"),
        0u);
    EXPECT_EQ(settings.set({"spacing"}).error(), "'spacing' is not PATH=VALUE.");
    EXPECT_EQ(settings.set({"sampling=1"}).error(), "sampling must be an object in braces, not 1.");
    EXPECT_FALSE(settings.set({"sampling.spacing_m=2cm"}).ok());
    EXPECT_FALSE(settings.set({"sampling.spacing_m.x=2"}).ok());
    EXPECT_FALSE(settings.set({"=2"}).ok());
}

}  // namespace
