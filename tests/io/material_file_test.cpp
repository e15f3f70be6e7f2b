#include <gtest/gtest.h>
#include <sherd/material.h>

#include <filesystem>
#include <fstream>

#include "support/altered_fields.h"
#include "support/temporary_path.h"

namespace {

using namespace sherd;

Result<Material> read(const std::string& text) {
    const std::string path = temporaryPath("material.json");
    std::ofstream(path) << text;
    return Material::fromJsonFile(path);
}

void expectError(const std::string& text, const std::string& sentence) {
    const auto material = read(text);
    ASSERT_FALSE(material.ok());
    EXPECT_NE(material.error().find(sentence), std::string::npos) << material.error();
}

const std::string needed = R"("youngs_modulus_pa": 5e10, "poisson_ratio": 0.2, "density_kg_m3": 2000,
    "tensile_strength_pa": 2e7, "fracture_energy_j_m2": 12)";

TEST(MaterialFile, GivesEveryField) {
    const auto tile =
        read("{" + needed + R"(, "name": "tile", "strength_scatter": 0.3, "compressive_strength_pa": 2e8,
        "weibull_modulus": 9, "weibull_volume_m3": 2e-6, "failure_criterion": "mohr_coulomb"})");
    ASSERT_TRUE(tile.ok()) << tile.error();
    const Material& m = tile.value();
    EXPECT_EQ(m.name, "tile");
    EXPECT_EQ(m.youngs_modulus_pa, 5e10);
    EXPECT_EQ(m.poisson_ratio, 0.2);
    EXPECT_EQ(m.density_kg_m3, 2000);
    EXPECT_EQ(m.tensile_strength_pa, 2e7);
    EXPECT_EQ(m.fracture_energy_j_m2, 12);
    EXPECT_EQ(m.strength_scatter, 0.3);
    EXPECT_EQ(m.compressive_strength_pa, 2e8);
    EXPECT_EQ(m.weibull_modulus, 9);
    EXPECT_EQ(m.weibull_volume_m3, 2e-6);
    EXPECT_EQ(m.failure_criterion, "mohr_coulomb");
}

TEST(MaterialFile, TakesTheRestFromTheMaterialItIsLike) {
    const auto weak = read(R"({"like": "glass", "tensile_strength_pa": 1e7})");
    ASSERT_TRUE(weak.ok()) << weak.error();
    EXPECT_EQ(weak.value().tensile_strength_pa, 1e7);
    EXPECT_EQ(weak.value().youngs_modulus_pa, Material::glass().youngs_modulus_pa);
    EXPECT_EQ(weak.value().compressive_strength_pa, Material::glass().compressive_strength_pa);
}

TEST(MaterialFile, ReadsBackWhatItWrites) {
    Material altered = Material::glass();
    alterFields(altered);
    EXPECT_NE(valuesOf(altered), valuesOf(Material::glass()));
    for (const Material& written : {altered, Material::plaster()}) {
        const auto read_back = Material::fromJson(written.toJson());
        ASSERT_TRUE(read_back.ok()) << read_back.error();
        EXPECT_EQ(valuesOf(read_back.value()), valuesOf(written));
    }
}

TEST(MaterialFile, TakesANameOrAFileFromText) {
    EXPECT_EQ(Material::fromJson("\"ice\"").value().name, "ice");
    const std::string path = temporaryPath("tile.json");
    std::ofstream(path) << R"({"like": "ceramic", "name": "tile"}  // comments are allowed)";
    const std::string folder = std::filesystem::path(path).parent_path().string(),
                      file = std::filesystem::path(path).filename().string();
    const auto tile = Material::fromJson("\"" + file + "\"", "material", folder);
    ASSERT_TRUE(tile.ok()) << tile.error();
    EXPECT_EQ(tile.value().name, "tile");
    const auto heavy =
        Material::fromJson(R"({"density_kg_m3": 9000, "like": ")" + file + "\"}", "material", folder);
    ASSERT_TRUE(heavy.ok()) << heavy.error();
    EXPECT_EQ(heavy.value().youngs_modulus_pa, Material::ceramic().youngs_modulus_pa);
    EXPECT_EQ(heavy.value().density_kg_m3, 9000);
    EXPECT_EQ(
        Material::fromJson("\"plastic\"", "bodies[0].material").error(),
        "bodies[0].material: There is no material 'plastic'; there are ceramic, plaster, glass, concrete, "
        "brick, stone, ice, wood. Or give the constants in braces, or a file of them that ends in .json.");
}

TEST(MaterialFile, ThatIsLikeItselfIsRefused) {
    const std::string path = temporaryPath("circle.json");
    std::ofstream(path) << "{\"like\": \"" << std::filesystem::path(path).filename().string() << "\"}";
    EXPECT_NE(Material::fromJsonFile(path).error().find("is \"like\" itself"), std::string::npos)
        << Material::fromJsonFile(path).error();
}

TEST(MaterialFile, WhatIsWrongIsNamed) {
    EXPECT_NE(Material::fromJsonFile("nowhere.json").error().find("nowhere.json: the file cannot be opened"),
              std::string::npos);
    expectError("{", "this is not JSON");
    expectError("[]", "material.json: the JSON must be an object in braces, not [].");
    expectError(R"({"like": "glas"})", "There is no material 'glas'");
    expectError(R"({"like": "glass", "density": 3})",
                "density is not a key; choose one of: like, name, youngs_modulus_pa,");
    expectError(R"({"tensile": 3})", "tensile is not a key; choose one of: like, name, youngs_modulus_pa,");
    expectError(R"({"density_kg_m3": 3})",
                "youngs_modulus_pa is missing; give it, or the material that gives it as \"like\".");
    expectError(R"({"like": "glass", "poisson_ratio": "high"})",
                "poisson_ratio must be a number, not \"high\".");
    expectError(R"({"like": "glass", "poisson_ratio": 0.5})", "poisson_ratio is 0.5 but must be between");
    expectError(R"({"like": "glass", "failure_criterion": "none"})",
                "failure_criterion is \"none\"; choose one of: largest_principal_stress, mohr_coulomb.");
}

}  // namespace
