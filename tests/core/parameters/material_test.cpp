#include <gtest/gtest.h>
#include <sherd/material.h>

#include <cmath>
#include <limits>

namespace {

using namespace sherd;

const Material known_materials[] = {Material::ceramic(),  Material::plaster(), Material::glass(),
                                    Material::concrete(), Material::stone(),   Material::ice(),
                                    Material::wood()};

TEST(Material, TheOnesThatComeWithItAreValidAndDiffer) {
    for (const Material& material : known_materials) EXPECT_EQ(material.validate().error(), "");
    EXPECT_LT(Material::plaster().tensile_strength_pa, Material::ceramic().tensile_strength_pa / 5);
    EXPECT_LT(Material::plaster().youngs_modulus_pa, Material::glass().youngs_modulus_pa / 5);
}

TEST(Material, ToughnessIsThatOfABrittleSolid) {
    // K_c = sqrt(G_c E / (1 - nu^2)): 0.1 to 2 MPa m^1/2 for plaster, glass, clayware, rock and ice; concrete
    // a little more.
    for (const Material& m : known_materials) {
        const double toughness =
            std::sqrt(m.fracture_energy_j_m2 * m.youngs_modulus_pa / (1 - m.poisson_ratio * m.poisson_ratio));
        EXPECT_GT(toughness, 0.1e6) << m.name;
        EXPECT_LT(toughness, 2.5e6) << m.name;
    }
}

void expectSentence(void (*spoil)(Material&), const std::string& sentence) {
    Material material = Material::glass();
    spoil(material);
    EXPECT_EQ(material.validate().error(), sentence);
}

TEST(Material, WhatIsOutOfRangeIsNamed) {
    expectSentence([](Material& m) { m.youngs_modulus_pa = 0; },
                   "Material 'glass': youngs_modulus_pa is 0 but must be positive, in Pa.");
    expectSentence([](Material& m) { m.poisson_ratio = 0.5; },
                   "Material 'glass': poisson_ratio is 0.5 but must be between 0 and 0.499 (0.5 is "
                   "incompressible).");
    expectSentence([](Material& m) { m.poisson_ratio = -0.1; },
                   "Material 'glass': poisson_ratio is -0.1 but must be between 0 and 0.499 (0.5 is "
                   "incompressible).");
    expectSentence([](Material& m) { m.density_kg_m3 = -2500; },
                   "Material 'glass': density_kg_m3 is -2500 but must be positive, in kg/m^3.");
    expectSentence([](Material& m) { m.tensile_strength_pa = 0; },
                   "Material 'glass': tensile_strength_pa is 0 but must be positive, in Pa.");
    expectSentence([](Material& m) { m.strength_scatter = 1.5; },
                   "Material 'glass': strength_scatter is 1.5 but must be between 0 and 1 (standard "
                   "deviation over mean).");
    expectSentence([](Material& m) { m.fracture_energy_j_m2 = 0; },
                   "Material 'glass': fracture_energy_j_m2 is 0 but must be positive, in J/m^2.");
    expectSentence([](Material& m) { m.failure_criterion = "rankine"; },
                   "Material 'glass': failure_criterion is 'rankine' but must be one of "
                   "largest_principal_stress, mohr_coulomb.");
}

TEST(Material, IsFoundByItsName) {
    for (const char* name : {"ceramic", "plaster", "glass", "concrete", "brick", "stone", "ice", "wood"}) {
        const auto material = Material::named(name);
        ASSERT_TRUE(material.ok()) << material.error();
        EXPECT_EQ(material.value().name, name);
        EXPECT_TRUE(material.value().validate().ok()) << material.value().validate().error();
    }
    EXPECT_EQ(
        Material::named("glas").error(),
        "There is no material 'glas'; there are ceramic, plaster, glass, concrete, brick, stone, ice, wood.");
}

TEST(Material, OfAnotherDensityHasTheSameSpeeds) {
    const Material given = Material::stone(), light = given.withDensity(0.125);
    EXPECT_EQ(light.density_kg_m3, 0.125);
    EXPECT_TRUE(light.validate().ok()) << light.validate().error();
    // Of sound, at which it breaks, and at which what breaks off flies away.
    for (double Material::*field : {&Material::youngs_modulus_pa, &Material::tensile_strength_pa,
                                    &Material::compressive_strength_pa, &Material::fracture_energy_j_m2})
        EXPECT_DOUBLE_EQ(light.*field / light.density_kg_m3, given.*field / given.density_kg_m3);
    EXPECT_EQ(light.poisson_ratio, given.poisson_ratio);
    for (const double none :
         {0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        const Status status = given.withDensity(none).validate();
        ASSERT_FALSE(status.ok()) << none;
        EXPECT_NE(status.error().find("density_kg_m3"), std::string::npos) << status.error();
    }
}

TEST(Material, NoNumberAndInfinityAreOutOfRange) {
    for (const double wrong :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        for (double Material::*member :
             {&Material::youngs_modulus_pa, &Material::poisson_ratio, &Material::density_kg_m3,
              &Material::tensile_strength_pa, &Material::strength_scatter, &Material::fracture_energy_j_m2}) {
            Material material = Material::ceramic();
            material.*member = wrong;
            EXPECT_FALSE(material.validate().ok());
        }
}

}  // namespace
