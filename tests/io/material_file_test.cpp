#include <gtest/gtest.h>
#include <sherd/material.h>

#include <fstream>

#include "support/temporary_path.h"

namespace {

using namespace sherd;

Result<Material> read(const std::string& text) {
    const std::string path = temporaryPath("material.json");
    std::ofstream(path) << text;
    return Material::fromJson(path);
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

TEST(MaterialFile, WhatIsWrongIsNamed) {
    EXPECT_NE(Material::fromJson("nowhere.json").error().find("nowhere.json: the file cannot be opened"),
              std::string::npos);
    expectError("{", "this is not JSON");
    expectError("[]", "the file must be an object");
    expectError(R"({"like": "glas"})", "There is no material 'glas'");
    expectError(R"({"like": "glass", "density": 3})", "unknown key \"density\"; known are name, like,");
    expectError(R"({"density_kg_m3": 3})",
                "lacks the key \"youngs_modulus_pa\"; give it, or the material that gives it as \"like\"");
    expectError(R"({"like": "glass", "poisson_ratio": "high"})", "\"poisson_ratio\" must be a number");
    expectError(R"({"like": "glass", "poisson_ratio": 0.5})", "poisson_ratio is 0.5 but must be between");
    expectError(R"({"like": "glass", "failure_criterion": "none"})",
                "but must be one of largest_principal_stress,");
}

}  // namespace
