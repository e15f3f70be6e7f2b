#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "cli/case_file.h"
#include "cli/csv_file.h"
#include "support/temporary_path.h"

namespace sherd::cli {
namespace {

std::string written(const std::string& name, const std::string& text) {
    const std::string path = temporaryPath(name);
    std::ofstream(path) << text;
    return path;
}

/// A case with `loads` and what follows it.
std::string caseWith(const std::string& loads) {
    return R"({"mesh": "m.obj", "material": {"youngs_modulus_pa": 5e9, "poisson_ratio": 0.2,
               "density_kg_m3": 2000}, "loads": )" +
           loads + "}";
}

TEST(CaseFile, ReadsTheFiveCases) {
    for (const char* name : {"slab_centre", "sphere_squeezed", "thick_cylinder", "cantilever", "dish_rim"}) {
        const auto read = readCase(std::string(SHERD_TEST_DATA) + "/cases/" + name + "/case.json");
        ASSERT_TRUE(read) << read.error();
        EXPECT_EQ(read.value().name, name);
        EXPECT_TRUE(std::ifstream(read.value().mesh).good()) << read.value().mesh;
        EXPECT_EQ(read.value().supports.size(), name == std::string("cantilever") ? 1u : 0u);
    }
}

TEST(CaseFile, ReadsSpinAndPressure) {
    const auto spinning = readCase(written("spin.json", caseWith("[], \"spin_rad_s\": [1, 2, 3]")));
    ASSERT_TRUE(spinning) << spinning.error();
    EXPECT_EQ(spinning.value().spin_rad_s, Vec3(1, 2, 3));
    const auto pressed = readCase(written("pressure.json", caseWith(R"([{"pressure_pa": 7,
        "region": {"cylinder": {"point": [0, 0, 0], "axis": [0, 0, 1], "radius": 2}}}])")));
    ASSERT_TRUE(pressed) << pressed.error();
    EXPECT_EQ(pressed.value().loads[0].pressure_pa, 7);
}

TEST(CaseFile, NamesFileAndKeyOfWhatIsWrong) {
    const std::string sphere = R"("region": {"sphere": {"centre": [0, 0, 0], "radius": 1}})";
    const std::pair<std::string, std::string> wrong[] = {
        {"{", "not JSON"},
        {"[]", "the JSON must be an object in braces, not []"},
        {"{}", "mesh is missing"},
        {caseWith("3"), "loads must be a list in brackets, not 3"},
        {caseWith("[]"), "nothing loads the body"},
        {caseWith("[{" + sphere + "}]"), "loads[0] must have either force_n"},
        {caseWith("[{" + sphere + ", \"force\": [1, 2, 3]}]"),
         "loads[0].force is not a key; choose one of: region, force_n"},
        {caseWith("[{" + sphere + ", \"force_n\": [1, 2]}]"),
         "loads[0].force_n must be a list of three numbers, not [1,2]"},
        {caseWith("[{" + sphere + ", \"force_n\": [1, 2, \"3\"]}]"),
         "loads[0].force_n[2] must be a number, not \"3\""},
        {caseWith("[{" + sphere + ", \"pressure_pa\": 1, \"force_n\": [1, 2, 3]}]"), "either"},
        {caseWith(R"([{"region": {"ball": 1}, "pressure_pa": 1}])"), "loads[0].region.ball is not a key"},
        {caseWith(R"([{"region": {}, "pressure_pa": 1}])"), "one of sphere, box and cylinder"},
        {caseWith(R"([{"region": {"sphere": {"centre": [0, 0, 0]}}, "pressure_pa": 1}])"),
         "loads[0].region.sphere.radius is missing"},
    };
    for (const auto& [text, sentence] : wrong) {
        const std::string error = readCase(written("wrong.json", text)).error();
        EXPECT_NE(error.find(sentence), std::string::npos) << error << " (expected: " << sentence << ")";
        EXPECT_NE(error.find("wrong.json"), std::string::npos) << error;
    }
}

TEST(CsvFile, ReadsColumnsByName) {
    const auto points = readPoints(written("points.csv", "far, z,y,x\r\n1,3,2,1\r\n\r\n0,-3e-1,+2,1\r\n"));
    ASSERT_TRUE(points) << points.error();
    ASSERT_EQ(points.value().size(), 2u);
    EXPECT_EQ(points.value()[0], Vec3(1, 2, 3));
    EXPECT_EQ(points.value()[1], Vec3(1, 2, -0.3));
}

TEST(CsvFile, NamesFileAndLineOfWhatIsWrong) {
    const std::pair<std::string, std::string> wrong[] = {
        {"", "cannot be read, or is empty"},
        {"x,y\n1,2\n", "z is not among"},
        {"x,y,z\n", "no points"},
        {"x,y,z\n1,2,3\n1,2\n", "line 3: z"},
        {"x,y,z\n1,nan,3\n", "line 2: y"},
        {"x,y,z\n1m,2,3\n", "line 2: x"},
    };
    for (const auto& [text, sentence] : wrong) {
        const std::string error = readPoints(written("wrong.csv", text)).error();
        EXPECT_NE(error.find(sentence), std::string::npos) << error << " (expected: " << sentence << ")";
    }
}

TEST(CsvFile, NumbersComeBackBitByBit) {
    StressTable table;
    table.positions = {{0.1, 1.0 / 3, -1e-300}};
    table.stresses = {SymmetricTensor::Constant(1e7 / 3)};
    const std::string path = written("stress.csv", "");
    ASSERT_TRUE(writeStress(table, path));
    const auto points = readPoints(path);
    ASSERT_TRUE(points) << points.error();
    EXPECT_EQ(points.value()[0], table.positions[0]);
}

}  // namespace
}  // namespace sherd::cli
