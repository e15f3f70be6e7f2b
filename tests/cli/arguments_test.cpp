#include "cli/arguments.h"

#include <gtest/gtest.h>

#include <iterator>

namespace sherd::cli {
namespace {

Result<Arguments> parsed(std::vector<const char*> line) {
    line.insert(line.begin(), {"sherd", "stress", "case.json", "--out", "o.csv"});
    return parseArguments(static_cast<int>(line.size()), line.data());
}

TEST(Arguments, ShortOptionsAndPathsChangeTheQuality) {
    const auto read = parsed({"--quality", "film", "--basis", "linear", "--rounds", "0", "--set",
                              "stress.resampling_margin=4", "sampling.smallest_fill=0.3"});
    ASSERT_TRUE(read.ok()) << read.error();
    const Settings& settings = read.value().settings;
    EXPECT_EQ(settings.sampling.smallest_count, Settings::forQuality(Quality::film).sampling.smallest_count);
    EXPECT_EQ(settings.stress.basis, Basis::linear);
    EXPECT_EQ(settings.stress.resampling_rounds, 0);
    EXPECT_EQ(settings.stress.resampling_margin, 4);
    EXPECT_EQ(settings.sampling.smallest_fill, 0.3);
}

TEST(Arguments, WhatIsNotPossibleIsNamedWithWhatIs) {
    const std::pair<std::vector<const char*>, std::string> wrong[] = {
        {{"--rounds", "5"}, "stress.resampling_rounds is 5 but must be between 0 and 4."},
        {{"--basis", "quintic"}, "stress.basis is \"quintic\"; choose one of: linear, quadratic, cubic."},
        {{"--set", "stress.radius=2"}, "stress.radius is not a key; choose one of: test_function,"},
        {{"--set", "fracture.seed=2"}, "'fracture.seed=2' changes nothing here"},
    };
    for (const auto& [line, sentence] : wrong)
        EXPECT_EQ(parsed(line).error().find(sentence), 0u) << parsed(line).error();
}

TEST(Arguments, HelpListsThePaths) {
    const auto help = parsed({"--help"});
    ASSERT_TRUE(help.ok());
    EXPECT_NE(help.value().help.find("sampling.spacing_m"), std::string::npos);
    EXPECT_NE(help.value().help.find("linear, quadratic, cubic"), std::string::npos);
    EXPECT_EQ(help.value().help.find("moment_order"), std::string::npos) << "the library sets it";
    EXPECT_NE(help.value().help.find("Usage: sherd stress"), std::string::npos) << help.value().help;
}

TEST(Arguments, HelpOfBakeSaysHowItIsCalled) {
    const char* line[] = {"sherd", "bake", "--help"};
    const auto help = parseArguments(static_cast<int>(std::size(line)), line);
    ASSERT_TRUE(help.ok()) << help.error();
    EXPECT_NE(help.value().help.find("Usage: sherd bake "), std::string::npos) << help.value().help;
}

TEST(Arguments, BakeTakesMaterialSettingsAndHowTheMeshIsTakenIn) {
    const char* line[] = {"sherd",   "bake",  "cup.obj", "--material", "glass",    "--set", "fracture.seed=7",
                          "--scale", "0.001", "-o",      "cup.sherd",  "--repair", "mend"};
    const auto read = parseArguments(static_cast<int>(std::size(line)), line);
    ASSERT_TRUE(read.ok()) << read.error();
    EXPECT_EQ(read.value().command, Arguments::Command::bake);
    const BakeArguments& bake = read.value().bake;
    EXPECT_EQ(bake.mesh, "cup.obj");
    EXPECT_EQ(bake.out, "cup.sherd");
    EXPECT_EQ(bake.repair.scale, 0.001);
    EXPECT_EQ(bake.repair.mode, Repair::Mode::mend);
    EXPECT_EQ(materialOf(bake).value().name, Material::glass().name);
    EXPECT_EQ(settingsOf(bake).value().fracture.seed, 7u);
    EXPECT_EQ(settingsOf(bake).value().sampling.smallest_count, Settings().sampling.smallest_count);
    EXPECT_EQ(parsed({}).value().command, Arguments::Command::stress);
}

}  // namespace
}  // namespace sherd::cli
