#include "core/damage/failure_criterion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace {

using namespace sherd;

const double never = std::numeric_limits<double>::infinity();

/// With a tensile strength of 2 MPa.
Material materialWith(double poisson_ratio, double compressive_over_tensile) {
    Material material;
    material.poisson_ratio = poisson_ratio;
    material.tensile_strength_pa = 2e6;
    material.compressive_strength_pa = 2e6 * compressive_over_tensile;
    return material;
}

/// Of any stress: ((1 + nu) s : s - nu tr(s)^2) / (2 E).
double energyDensity(const SymmetricTensor& s, const Material& m) {
    const double trace = s.head<3>().sum(),
                 square = s.head<3>().squaredNorm() + 2 * s.tail<3>().squaredNorm();
    return ((1 + m.poisson_ratio) * square - m.poisson_ratio * trace * trace) / (2 * m.youngs_modulus_pa);
}

/// Energy density of the multiple of a stress that just fails, over the criterion's bound; infinite if none
/// does.
double energyOverBound(const SymmetricTensor& stress, const FailureCriterion& criterion, const Material& m) {
    const double equivalent = criterion.equivalent_stress_pa(principalStresses(stress), m);
    if (!(equivalent > 0)) return never;
    const SymmetricTensor failing = stress * (m.tensile_strength_pa / equivalent);
    return energyDensity(failing, m) / criterion.least_energy_density_j_m3(m.tensile_strength_pa, m);
}

class AnyCriterion : public testing::TestWithParam<const FailureCriterion*> {
  protected:
    template <class Check>
    void forMaterials(const Check& check) {
        for (const double poisson_ratio : {0.0, 0.1, 0.22, 0.33, 0.4, 0.45, 0.48, 0.499})
            for (const double ratio : {1.0, 1.5, 3.0, 8.75, 20.0, never}) {
                SCOPED_TRACE("nu " + std::to_string(poisson_ratio) + ", f_c / f_t " + std::to_string(ratio));
                check(materialWith(poisson_ratio, ratio));
            }
    }

    std::mt19937_64 random_{5};
    double number(double low, double high) { return low + (high - low) * (random_() >> 11) * 0x1p-53; }
    SymmetricTensor tensor() {
        SymmetricTensor s;
        for (double& component : s) component = number(-1, 1);
        return s;
    }
};

TEST_P(AnyCriterion, NoStressFailsWithLessEnergyThanTheBound) {
    forMaterials([&](const Material& material) {
        for (int i = 0; i < 5000; ++i) {
            SymmetricTensor stress = tensor();
            // From spread evenly to nearly hydrostatic, which costs next to nothing at nu near 0.5.
            if (i % 2)
                stress =
                    std::pow(10, -number(0, 4)) * stress + (SymmetricTensor() << 1, 1, 1, 0, 0, 0).finished();
            EXPECT_GE(energyOverBound(stress, *GetParam(), material), 1 - 1e-9) << stress.transpose();
        }
    });
}

TEST_P(AnyCriterion, SomeStressFailsWithTheEnergyOfTheBound) {
    forMaterials([&](const Material& material) {
        SymmetricTensor best = (SymmetricTensor() << 1, 0.1, 0.1, 0, 0, 0).finished();
        double least = energyOverBound(best, *GetParam(), material);
        for (double step = 1; step > 1e-5; step *= 0.8)
            for (int i = 0; i < 100; ++i) {
                const SymmetricTensor tried = best / best.norm() + step * tensor();
                const double energy = energyOverBound(tried, *GetParam(), material);
                if (energy >= least) continue;
                least = energy;
                best = tried;
            }
        EXPECT_LT(least, 1.01);
    });
}

TEST_P(AnyCriterion, TensionInOneDirectionFailsAtTheTensileStrength) {
    forMaterials([&](const Material& material) {
        const SymmetricTensor tension = (SymmetricTensor() << 0, 2e6, 0, 0, 0, 0).finished();
        EXPECT_NEAR(GetParam()->equivalent_stress_pa(principalStresses(tension), material), 2e6, 1e-2);
    });
}

TEST_P(AnyCriterion, EquivalentStressIsProportionalToStress) {
    forMaterials([&](const Material& material) {
        const SymmetricTensor stress = tensor();
        const auto equivalent = [&](double factor) {
            return GetParam()->equivalent_stress_pa(principalStresses(factor * stress), material);
        };
        EXPECT_NEAR(equivalent(7) / 7, equivalent(1), 1e-12);
    });
}

TEST_P(AnyCriterion, IsFoundByItsName) {
    EXPECT_EQ(failureCriterion(GetParam()->name), GetParam());
    const std::vector<std::string> names = failureCriterionNames();
    EXPECT_EQ(std::count(names.begin(), names.end(), GetParam()->name), 1);
}

INSTANTIATE_TEST_SUITE_P(FailureCriterion, AnyCriterion, testing::ValuesIn(failureCriteria()),
                         [](const auto& criterion) { return std::string(criterion.param->name); });

double equivalentStress(const char* criterion, const Vec3& principal, double compressive_over_tensile) {
    const SymmetricTensor stress = (SymmetricTensor() << principal, Vec3::Zero()).finished();
    return failureCriterion(criterion)->equivalent_stress_pa(principalStresses(stress),
                                                             materialWith(0.2, compressive_over_tensile));
}

TEST(FailureCriterion, LargestPrincipalStressComparesTensionAndCompressionEachWithItsStrength) {
    const char* name = "largest_principal_stress";
    EXPECT_NEAR(equivalentStress(name, {1, -6, 0}, 3), 2, 1e-12);
    EXPECT_NEAR(equivalentStress(name, {3, -6, 0}, 3), 3, 1e-12);
    EXPECT_NEAR(equivalentStress(name, {1, -6, 0}, never), 1, 1e-12);
}

TEST(FailureCriterion, MohrCoulombAddsTensionAndCompression) {
    const char* name = "mohr_coulomb";
    EXPECT_NEAR(equivalentStress(name, {0, -6, 0}, 3), 2, 1e-6);    // uniaxial compression
    EXPECT_NEAR(equivalentStress(name, {1, -6, 0.3}, 3), 3, 1e-6);  // the middle stress plays no part
    EXPECT_NEAR(equivalentStress(name, {-6, 1, -2}, 3), 3, 1e-6);   // nor does the order
    EXPECT_NEAR(equivalentStress(name, {-1, -6, -1}, 3), 1, 1e-6);  // side pressure strengthens
    EXPECT_NEAR(equivalentStress(name, {4, -4, 0}, 1), 8, 1e-6);    // f_c = f_t: Tresca's
}

TEST(FailureCriterion, MohrCoulombIsRankinesIfNothingCrushes) {
    const Material material = materialWith(0.3, never);
    const FailureCriterion &rankine = *failureCriterion("largest_principal_stress"),
                           &coulomb = *failureCriterion("mohr_coulomb");
    std::mt19937_64 random(3);
    for (int i = 0; i < 1000; ++i) {
        SymmetricTensor s;
        for (double& component : s) component = static_cast<double>(random() >> 11) * 0x1p-52 - 1;
        const double largest = largestPrincipal(s);
        EXPECT_EQ(coulomb.equivalent_stress_pa(principalStresses(s), material), largest);
        EXPECT_EQ(rankine.equivalent_stress_pa(principalStresses(s), material), std::max(0.0, largest));
    }
    EXPECT_EQ(rankine.least_energy_density_j_m3(2e6, material),
              coulomb.least_energy_density_j_m3(2e6, material));
}

// The closed form of tension alone: s^2 / (2 E) (1 - 2 nu^2 / (1 - nu)).
TEST(FailureCriterion, BoundOfTheLargestPrincipalStress) {
    for (const double nu : {0.0, 0.22, 0.4, 0.499}) {
        const Material m = materialWith(nu, 5);
        EXPECT_NEAR(failureCriterion("largest_principal_stress")->least_energy_density_j_m3(3e6, m) /
                        (9e12 / (2 * m.youngs_modulus_pa) * (1 - 2 * nu * nu / (1 - nu))),
                    1, 1e-12);
    }
}

TEST(FailureCriterion, ThereIsNoneOfAnotherName) {
    EXPECT_EQ(failureCriterion("largest"), nullptr);
    EXPECT_EQ(failureCriterion(""), nullptr);
}

}  // namespace
